// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/triangular_solves.hpp"
#include "methods/knots/segment_sum.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// While the kernel is wider than twice what it ends at, so many points will do, or a third of all:
// a wide kernel blurs more than fewer points do.
constexpr double kWide = 2.0;
constexpr std::size_t kEnough = 700, kMostStride = 3;

// Where no knot moved by more than this share of the kernel, what a narrower one would still have
// found is near: it narrows by two steps at once.
constexpr double kCalm = 0.02;

// A kernel that is no wider than so many times what it ends at tells of a hopeless fit already.
constexpr double kNarrow = 1.6;

// What disagrees so many times as much as another, and no longer agrees better by so much from
// one iteration to the next, is not going to end better than it.
constexpr double kHopeless = 1.5, kGetsBetter = 0.9;  // disagreements' ratios

// No robot moves so far in one step of the solver: what does is a singular system's rounding.
constexpr double kImpossible = 1e3;  // [m, rad]

/// Adds a segment's H.
void add_blocks(BandedSystem& system, std::size_t segment, const SegmentSums& sums) {
  system.add(segment + 1, segment + 1, sums.first);
  system.add(segment + 2, segment + 1, sums.between);
  system.add(segment + 2, segment + 2, sums.last);
}

void add_surfels(BandedSystem& system, const std::vector<SegmentSum>& sums,
                 KnotRegistration& result) {
  result.matches = 0;
  result.clouds = 0;
  result.misfit = 0.0;
  result.rigid = {};
  result.doubtful.setZero();
  result.squared_distance = 0.0;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    const SegmentSums& sum = sums[s].surfels;
    add_blocks(system, s, sum);
    system.add(s + 1, sum.first_gradient);
    system.add(s + 2, sum.last_gradient);
    result.matches += sums[s].matches;
    result.clouds += sums[s].clouds;
    result.misfit += sum.misfit + sums[s].unseen;
    result.rigid.H += sum.rigid();
    result.doubtful += sums[s].doubtful.rigid();
    result.rigid.g += sum.first_gradient + sum.last_gradient;
    result.rigid.weight += sum.weight;
    result.rigid.weighted_squares += sum.weighted_squares;
    result.rigid.count += sum.count;
    result.squared_distance += sum.squared_distance;
  }
}

/// Moves the knots; returns the largest change of one of the new scan's, or none if no robot can
/// have moved so.
std::optional<double> move_knots(const std::vector<Twist>& steps, KnotWindow& window) {
  double largest = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double change = steps[k].cwiseAbs().maxCoeff();
    if (!steps[k].allFinite() || change > kImpossible) return std::nullopt;
    window.knots[k] = displaced(window.knots[k], steps[k]);
    if (k >= 2) largest = std::max(largest, change);
  }
  return largest;
}

/// What the knots would be, and how well they would be known, were every residual independent.
/// `assumed`: the equations that were solved, `surfels`: of them, those of the residuals.
/// @return whether there is a finite solution
bool count_in_full(const BandedSystem& assumed, const BandedSystem& surfels,
                   const std::vector<SegmentSum>& sums, const std::vector<Twist>& steps,
                   double independence, KnotRegistration& result) {
  BandedSystem full = assumed;
  full.add(surfels, 1.0 / independence - 1.0);
  BandedSystem doubtful(steps.size());
  for (std::size_t s = 0; s < sums.size(); ++s) add_blocks(doubtful, s, sums[s].doubtful);
  BandedSystem worth = full;
  worth.add(doubtful, -1.0 / independence);
  if (!full.factorise() || !worth.factorise()) return false;
  result.full_covariance = worth.covariance();
  result.held_back = full.solve();  // [K34]
  for (std::size_t k = 0; k < steps.size(); ++k) result.held_back[k] -= steps[k];
  return true;
}

}  // namespace

Matrix6 KnotRegistration::covariance_at(std::int64_t instant_ns) const {
  return full_covariance.at(window.place_of(instant_ns));
}

Twist KnotRegistration::held_back_at(std::int64_t instant_ns) const {
  const auto [a, u] = window.place_of(instant_ns);
  return (1.0 - u) * held_back[a] + u * held_back[a + 1];
}

double KnotRegistration::disagreement(double unseen_weight) const {
  return misfit - (1.0 - unseen_weight) * unseen;  // [K13]
}

double KnotRegistration::misfit_of_seen() const {
  return unseen < 1.0 ? (misfit - unseen) / (1.0 - unseen) : 1.0;
}

bool is_hopeless(double disagreement, double before, double least) {
  return disagreement > kHopeless * least && disagreement > kGetsBetter * before;
}

Annealing usual_annealing(const Config::Knots& config) {
  return {config.kernel_start, config.kernel_decay, config.max_iterations};
}

Annealing patient_annealing(const Config::Knots& config) {
  return {2.0 * config.kernel_start, std::sqrt(config.kernel_decay), 2 * config.max_iterations};
}

KnotRegistration register_knots(KnotPoints& points, const KnotProblem& problem,
                                const KnotWindow& start, const Annealing& annealing,
                                const Abandon& abandon) {
  const Config::Knots& config = problem.config;
  KnotRegistration result;
  result.window = start;
  std::vector<SegmentSum> sums(start.segments());
  const std::size_t wide_stride =
      std::clamp<std::size_t>(points.points.size() / kEnough, 1, kMostStride);
  double kernel = annealing.start;
  for (int t = 1; t <= annealing.max_iterations; ++t) {
    problem.begin_step(Step::search);
    const double ratio = std::max(kernel / config.kernel_end, 1.0);  // [K11]
    const bool wide = ratio > kWide && t < annealing.max_iterations;
    const Look look{ratio * ratio, ratio > 1.0 ? problem.map.level_of(kernel) : 0,
                    wide ? wide_stride : 1, ratio <= 1.0 || t == annealing.max_iterations};
    problem.workers.for_each(sums.size(), [&](std::size_t s) {
      sums[s] = sum_segment(points, s, problem.map, result.window, look, config);
    });
    problem.begin_step(Step::solve);
    const double before = result.disagreement(config.unseen_weight);
    BandedSystem surfels(start.knots.size());
    add_surfels(surfels, sums, result);
    BandedSystem system = surfels;
    const auto all = static_cast<double>(std::max<std::size_t>(points.points.size(), 1));
    result.misfit /= all;  // [K12]
    result.unseen = 1.0 - result.matches / all;
    problem.prior.add_to(system, result.window);
    problem.model.add_to(system, result.window, problem.prior.means[1].rotation);
    result.iterations = t;
    result.settling += ratio <= 1.0 ? 1 : 0;
    const BandedSystem assumed = system;
    result.solved = system.factorise();
    if (!result.solved) return result;
    const std::vector<Twist> steps = system.solve();
    const std::optional<double> change = move_knots(steps, result.window);
    result.solved = change.has_value();
    if (!result.solved) return result;
    if (abandon && t > 1 && ratio < kNarrow && abandon(result, before)) {
      result.solved = false;
      return result;
    }
    result.converged = ratio <= 1.0 && *change < config.convergence;
    if (result.converged || t == annealing.max_iterations) {
      result.covariance = system.covariance();
      result.last_two = system.last_two_information();
      for (std::size_t s = 0; s < sums.size(); ++s) {
        const auto of_segment = static_cast<double>(points.begins[s + 1] - points.begins[s]);
        const double sum = sums[s].surfels.misfit + config.unseen_weight * sums[s].unseen;
        result.disagreements.push_back(sum / std::max(of_segment, 1.0));
        result.neighbours.push_back(sums[s].surfels.neighbours);
      }
      result.solved = count_in_full(assumed, surfels, sums, steps, config.independence, result);
      return result;
    }
    kernel *= *change < kCalm * kernel ? annealing.decay * annealing.decay : annealing.decay;
  }
  return result;
}

}  // namespace surefoot
