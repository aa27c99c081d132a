// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/knot_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "odometry/segment_motion.hpp"

namespace surefoot {

namespace {

/// Sums over one segment's points, whose pose is (1 - u) of one knot's and u of the next one's.
struct SegmentSum {
  Matrix6 first = Matrix6::Zero();    // sum (1 - u)^2 w J^T J
  Matrix6 between = Matrix6::Zero();  // sum u (1 - u) w J^T J
  Matrix6 last = Matrix6::Zero();     // sum u^2 w J^T J
  Twist first_gradient = Twist::Zero();
  Twist last_gradient = Twist::Zero();
  double weight = 0.0;
  double weighted_squares = 0.0;
  double squared_distance = 0.0;
  double misfit = 0.0;  // sum over points, each 0 to 1
  int matches = 0;      // points
  int residuals = 0;    // of them; a pole has two
  // Gradients of neighbours: of the segment's surfels that face along x, y and z.
  std::array<Twist, 3> neighbours = {Twist::Zero(), Twist::Zero(), Twist::Zero()};

  void add(const Twist& J, double residual, double u, double w) {
    const Matrix6 JJ = w * J * J.transpose();
    first += (1.0 - u) * (1.0 - u) * JJ;
    between += u * (1.0 - u) * JJ;
    last += u * u * JJ;
    first_gradient += (1.0 - u) * w * residual * J;
    last_gradient += u * w * residual * J;
    weight += w;
    weighted_squares += w * residual * residual;
    ++residuals;
    int axis = 0;
    J.head<3>().cwiseAbs().maxCoeff(&axis);
    neighbours[static_cast<std::size_t>(axis)] += w * residual * J;
  }
};

// While the kernel is wider than twice what it ends at, so many points will do, or a third of all.
constexpr double kWide = 2.0;
constexpr std::size_t kEnough = 700, kMostStride = 3;

/// How an iteration looks at the map.
struct Look {
  double inflation;    // of the noise variance
  int finest;          // grid of the map
  std::size_t stride;  // every so many-th point, for so many
};

/// A residual [m] across a surfel of some variance [m^2], under the Geman-McClure kernel at three
/// standard deviations.
struct Kernel {
  double weight;
  double misfit;  // 0 at a residual of zero, 1 far away
};

/// `independence`: neighbouring points share the error of their surfel and of their instant, so
/// that many count as few.
Kernel kernel_of(double residual, double surfel_variance, const Look& look,
                 const Config::Knots& config) {
  const double variance = look.inflation * (config.noise * config.noise + surfel_variance);
  const double cauchy = 1.0 / (1.0 + residual * residual / (9.0 * variance));
  const double weight = static_cast<double>(look.stride) * config.independence;
  return {weight * cauchy * cauchy / variance, 1.0 - cauchy};
}

SegmentSum sum_segment(KnotPoints& points, std::size_t segment, const SurfelMap& map,
                       const KnotWindow& window, const Look& look, const Config::Knots& config) {
  SegmentSum sum;
  const Pose& T_first = window.knots[segment + 1];
  const Pose& T_last = window.knots[segment + 2];
  const SegmentMotion motion(T_first, se3_log(T_first.inverse() * T_last));
  for (std::size_t i = points.begins[segment]; i < points.begins[segment + 1]; i += look.stride) {
    KnotPoints::Point& point = points.points[i];
    const double u = point.share;
    const Eigen::Vector3d place = motion(u, point.position);
    const Eigen::Vector3d sensor =
        T_first.translation + u * (T_last.translation - T_first.translation);
    const Eigen::Vector3d s = place - sensor;
    const Surfel* const surfel = map.find(place, s, look.finest, point.place);
    if (surfel == nullptr) {
      sum.misfit += 1.0;
      continue;
    }
    for (int d = 0; d < surfel->directions; ++d) {
      const Eigen::Vector3d& n = surfel->across[d];
      const double residual = n.dot(place - surfel->mean);
      Twist J;
      J << n, s.cross(n);
      const Kernel kernel = kernel_of(residual, surfel->variance[d], look, config);
      sum.add(J, residual, u, kernel.weight);
      sum.squared_distance += kernel.weight * s.squaredNorm();
      sum.misfit += kernel.misfit / surfel->directions;
    }
    ++sum.matches;
  }
  return sum;
}

void add_surfels(BandedSystem& system, const std::vector<SegmentSum>& sums,
                 KnotRegistration& result) {
  result.matches = 0;
  result.misfit = 0.0;
  result.rigid = {};
  result.squared_distance = 0.0;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    const SegmentSum& sum = sums[s];
    system.add(s + 1, s + 1, sum.first);
    system.add(s + 2, s + 1, sum.between);
    system.add(s + 2, s + 2, sum.last);
    system.add(s + 1, sum.first_gradient);
    system.add(s + 2, sum.last_gradient);
    result.matches += sum.matches;
    result.misfit += sum.misfit;
    result.rigid.H += sum.first + 2.0 * sum.between + sum.last;
    result.rigid.g += sum.first_gradient + sum.last_gradient;
    result.rigid.weight += sum.weight;
    result.rigid.weighted_squares += sum.weighted_squares;
    result.rigid.count += sum.residuals;
    result.squared_distance += sum.squared_distance;
  }
}

void add_prior(BandedSystem& system, const KnotWindow& window, const KnotPrior& prior) {
  Eigen::Matrix<double, 12, 1> e;
  e << difference(window.knots[0], prior.means[0]), difference(window.knots[1], prior.means[1]);
  const Eigen::Matrix<double, 12, 1> gradient = prior.information * e;
  system.add(0, 0, prior.information.topLeftCorner<6, 6>());
  system.add(1, 0, prior.information.bottomLeftCorner<6, 6>());
  system.add(1, 1, prior.information.bottomRightCorner<6, 6>());
  system.add(0, gradient.head<6>());
  system.add(1, gradient.tail<6>());
}

/// How much more the sums of neighbours' residuals vary than they would were all residuals
/// independent: the clusters' outer products B against s^2 H.
double dependence_of(const std::vector<SegmentSum>& sums, const NormalEquations<6>& rigid,
                     double independence) {
  Matrix6 B = Matrix6::Zero();
  for (const SegmentSum& sum : sums) {
    for (const Twist& gradient : sum.neighbours) B += gradient * gradient.transpose();
  }
  const double variance = rigid.weighted_squares / std::max(rigid.count, 1);
  const Eigen::LDLT<Matrix6> solver(rigid.H);
  if (variance <= 0.0 || solver.info() != Eigen::Success || !solver.isPositive()) {
    return 1.0 / independence;
  }
  const double ratio = solver.solve(B).trace() / (6.0 * variance);
  return std::isfinite(ratio) ? ratio : 1.0 / independence;
}

/// Moves the knots; returns the largest change of one of the new scan's, or none if no robot can
/// have moved so.
std::optional<double> move_knots(const std::vector<Twist>& steps, KnotWindow& window) {
  constexpr double kImpossible = 1e3;  // [m, rad]
  double largest = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double change = steps[k].cwiseAbs().maxCoeff();
    if (!steps[k].allFinite() || change > kImpossible) return std::nullopt;
    window.knots[k] = displaced(window.knots[k], steps[k]);
    if (k >= 2) largest = std::max(largest, change);
  }
  return largest;
}

}  // namespace

Matrix6 KnotRegistration::covariance_at(std::int64_t instant_ns) const {
  const double seconds = 1e-9 * static_cast<double>(instant_ns - window.begin_ns);
  const auto last = static_cast<double>(window.segments() - 1);
  const auto segment = static_cast<std::size_t>(std::clamp(seconds / window.step, 0.0, last));
  const double u = std::clamp(seconds / window.step - static_cast<double>(segment), 0.0, 1.0);
  const std::size_t a = segment + 1, b = segment + 2;
  const Matrix6 between = covariance(a, b);
  return (1.0 - u) * (1.0 - u) * covariance(a, a) + u * u * covariance(b, b) +
         u * (1.0 - u) * (between + between.transpose());
}

Annealing usual_annealing(const Config::Knots& config) {
  return {config.kernel_start, config.kernel_decay, config.max_iterations};
}

Annealing patient_annealing(const Config::Knots& config) {
  return {2.0 * config.kernel_start, std::sqrt(config.kernel_decay), 2 * config.max_iterations};
}

KnotRegistration register_knots(KnotPoints& points, const SurfelMap& map,
                                const KnotWindow& predicted, const KnotPrior& prior,
                                const VelocityModel& model, const Annealing& annealing,
                                const Config::Knots& config, const Workers& workers,
                                const StepObserver& begin_step) {
  KnotRegistration result;
  result.window = predicted;
  const Eigen::Quaterniond& heading = prior.means[1].rotation;
  std::vector<SegmentSum> sums(predicted.segments());
  const std::size_t wide_stride =
      std::clamp<std::size_t>(points.points.size() / kEnough, 1, kMostStride);
  double kernel = annealing.start;
  for (int t = 1; t <= annealing.max_iterations; ++t) {
    begin_step(Step::search);
    const double ratio = std::max(kernel / config.kernel_end, 1.0);
    const bool wide = ratio > kWide && t < annealing.max_iterations;
    const Look look{ratio * ratio, ratio > 1.0 ? map.level_of(kernel) : 0, wide ? wide_stride : 1};
    workers.for_each(sums.size(), [&](std::size_t s) {
      sums[s] = sum_segment(points, s, map, result.window, look, config);
    });
    begin_step(Step::solve);
    BandedSystem system(predicted.knots.size());
    add_surfels(system, sums, result);
    const auto all = static_cast<double>(std::max<std::size_t>(points.points.size(), 1));
    result.misfit /= all;
    result.unseen = 1.0 - result.matches / all;
    add_prior(system, result.window, prior);
    model.add_to(system, result.window, heading);
    result.iterations = t;
    result.solved = system.factorise();
    if (!result.solved) return result;
    const std::optional<double> change = move_knots(system.solve(), result.window);
    result.solved = change.has_value();
    if (!result.solved) return result;
    result.converged = ratio <= 1.0 && *change < config.convergence;
    if (result.converged || t == annealing.max_iterations) {
      result.covariance = system.covariance();
      result.last_two = system.last_two_information();
      result.dependence = dependence_of(sums, result.rigid, config.independence);
      return result;
    }
    kernel *= annealing.decay;
  }
  return result;
}

}  // namespace surefoot
