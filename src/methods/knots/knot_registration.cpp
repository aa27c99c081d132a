// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/segment_motion.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

/// The lower triangle of a symmetric 6 x 6 matrix, column by column, each from an even row on: all
/// of it comes in pairs, which a processor multiplies at once.
using Triangle = Eigen::Matrix<double, 24, 1>;

constexpr int even(int row) { return row & ~1; }

Matrix6 matrix_of(const Triangle& triangle) {
  Matrix6 M;
  int at = 0;
  for (int column = 0; column < 6; ++column) {
    for (int row = even(column); row < 6; ++row, ++at) {
      if (row >= column) M(row, column) = M(column, row) = triangle[at];
    }
  }
  return M;
}

/// Adds a b^T, which is symmetric.
void add_product(const Twist& a, const Twist& b, Triangle& sum) {
  int at = 0;
  for (int column = 0; column < 6; ++column) {
    for (int row = even(column); row < 6; row += 2, at += 2) {
      sum.segment<2>(at) += a[column] * b.segment<2>(row);
    }
  }
}

/// Sums over the residuals of one point.
struct PointSum {
  Triangle H = Triangle::Zero();         // sum w J^T J
  Triangle doubtful = Triangle::Zero();  // of H, what a cloud is not worth
  Twist g = Twist::Zero();               // sum w r J

  void add(const Twist& J, double w, const Twist& gradient) {
    const Twist wJ = w * J;
    add_product(wJ, J, H);
    g += gradient;
  }
};

/// H of a segment's points, as blocks of its two knots.
struct SegmentBlocks {
  Triangle first = Triangle::Zero();    // sum (1 - u)^2 H
  Triangle between = Triangle::Zero();  // sum u (1 - u) H
  Triangle last = Triangle::Zero();     // sum u^2 H

  void add(const Triangle& H, double u) {
    first += (1.0 - u) * (1.0 - u) * H;  // [K3]
    between += u * (1.0 - u) * H;
    last += u * u * H;
  }
  void add_to(BandedSystem& system, std::size_t segment) const {
    system.add(segment + 1, segment + 1, matrix_of(first));
    system.add(segment + 2, segment + 1, matrix_of(between));
    system.add(segment + 2, segment + 2, matrix_of(last));
  }
  /// Both knots moved as one.
  [[nodiscard]] Matrix6 rigid() const { return matrix_of(first + 2.0 * between + last); }
};

/// Sums over one segment's points, whose pose is (1 - u) of one knot's and u of the next one's.
struct SegmentSum {
  SegmentBlocks H;
  SegmentBlocks doubtful;  // of H, what clouds are not worth
  Twist first_gradient = Twist::Zero();
  Twist last_gradient = Twist::Zero();
  double weight = 0.0;
  double weighted_squares = 0.0;
  double squared_distance = 0.0;
  double misfit = 0.0;  // sum over points, each 0 to 1
  int matches = 0;      // points
  int residuals = 0;    // of them; a pole has two, a cloud three
  // Gradients of neighbours: of the segment's surfels that face along x, y and z.
  std::array<Twist, 3> neighbours = {Twist::Zero(), Twist::Zero(), Twist::Zero()};

  void add(const PointSum& point, double u) {
    H.add(point.H, u);
    first_gradient += (1.0 - u) * point.g;
    last_gradient += u * point.g;
    ++matches;
  }

  void count(const Twist& J, double residual, double w, const Twist& gradient) {
    weight += w;
    weighted_squares += w * residual * residual;
    ++residuals;
    int axis = 0;
    J.head<3>().cwiseAbs().maxCoeff(&axis);
    neighbours[static_cast<std::size_t>(axis)] += gradient;
  }
};

// While the kernel is wider than twice what it ends at, so many points will do, or a third of all:
// a wide kernel blurs more than fewer points do.
constexpr double kWide = 2.0;
constexpr std::size_t kEnough = 700, kMostStride = 3;

// Scale of the Geman-McClure kernel in standard deviations of a residual: the usual three.
constexpr double kKernelSigmas = 3.0;

// No robot moves so far in one step of the solver: what does is a singular system's rounding.
constexpr double kImpossible = 1e3;  // [m, rad]

/// How an iteration looks at the map.
struct Look {
  double inflation;    // of the noise variance
  int finest;          // grid of the map
  std::size_t stride;  // every so many-th point, for so many
};

/// A residual [m] across a surfel, under the Geman-McClure kernel at three standard deviations.
struct Kernel {
  double weight;
  double misfit;  // 0 at a residual of zero, 1 far away
};

/// `independence`: neighbouring points share the error of their surfel and of their instant, so
/// that many count as few; within a cloud, fewer yet.
Kernel kernel_of(double residual, const Surfel& surfel, int direction, const Look& look,
                 const Config::Knots& config) {
  const double variance =
      look.inflation * (config.noise * config.noise + surfel.variance[direction]);
  // [K4]
  const double cauchy =
      1.0 / (1.0 + residual * residual / (kKernelSigmas * kKernelSigmas * variance));
  const double weight = static_cast<double>(look.stride) * config.independence *
                        (surfel.cloud() ? config.cloud_weight : 1.0);
  return {weight * cauchy * cauchy / variance, 1.0 - cauchy};
}

SegmentSum sum_segment(KnotPoints& points, std::size_t segment, const KnotProblem& problem,
                       const KnotWindow& window, const Look& look) {
  SegmentSum sum;
  const Pose& T_first = window.knots[segment + 1];
  const Pose& T_last = window.knots[segment + 2];
  const SegmentMotion motion(T_first, se3_log(T_first.inverse() * T_last));  // [K1]
  for (std::size_t i = points.begins[segment]; i < points.begins[segment + 1]; i += look.stride) {
    KnotPoints::Point& point = points.points[i];
    const double u = point.share;
    const Eigen::Vector3d place = motion(u, point.position);
    const Eigen::Vector3d sensor =
        T_first.translation + u * (T_last.translation - T_first.translation);
    const Eigen::Vector3d s = place - sensor;
    const Surfel* const surfel = problem.map.find(place, s, look.finest, point.place);
    if (surfel == nullptr) {
      sum.misfit += 1.0;
      continue;
    }
    PointSum of_point;
    const double squared_distance = s.squaredNorm();
    for (int d = 0; d < surfel->directions; ++d) {
      const Eigen::Vector3d& n = surfel->across[d];
      const double residual = n.dot(place - surfel->mean);  // [K2]
      Twist J;
      J << n, s.cross(n);
      const Kernel kernel = kernel_of(residual, *surfel, d, look, problem.config);
      const Twist gradient = kernel.weight * residual * J;
      of_point.add(J, kernel.weight, gradient);
      sum.count(J, residual, kernel.weight, gradient);
      const double doubt = kernel.weight * (1.0 - surfel->worth[d]);
      if (doubt > 0.0 && look.inflation <= 1.0) add_product(doubt * J, J, of_point.doubtful);
      sum.squared_distance += kernel.weight * squared_distance;
      sum.misfit += kernel.misfit / surfel->directions;
    }
    sum.add(of_point, u);
    if (surfel->cloud() && look.inflation <= 1.0) sum.doubtful.add(of_point.doubtful, u);
  }
  return sum;
}

void add_surfels(BandedSystem& system, const std::vector<SegmentSum>& sums,
                 KnotRegistration& result) {
  result.matches = 0;
  result.misfit = 0.0;
  result.rigid = {};
  result.doubtful.setZero();
  result.squared_distance = 0.0;
  for (std::size_t s = 0; s < sums.size(); ++s) {
    const SegmentSum& sum = sums[s];
    sum.H.add_to(system, s);
    system.add(s + 1, sum.first_gradient);
    system.add(s + 2, sum.last_gradient);
    result.matches += sum.matches;
    result.misfit += sum.misfit;
    result.rigid.H += sum.H.rigid();
    result.doubtful += sum.doubtful.rigid();
    result.rigid.g += sum.first_gradient + sum.last_gradient;
    result.rigid.weight += sum.weight;
    result.rigid.weighted_squares += sum.weighted_squares;
    result.rigid.count += sum.residuals;
    result.squared_distance += sum.squared_distance;
  }
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
  // What six degrees of freedom have been fitted to varies less than it would have.
  const double clusters = 3.0 * static_cast<double>(sums.size());
  const double freedom = clusters / std::max(clusters - 6.0, 1.0);
  const double ratio = freedom * solver.solve(B).trace() / (6.0 * variance);  // [K21]
  return std::isfinite(ratio) ? ratio : 1.0 / independence;
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

/// The knot before an instant, and the share of the way to the next.
std::pair<std::size_t, double> place_of(std::int64_t instant_ns, const KnotWindow& window) {
  const double steps = seconds(instant_ns - window.begin_ns) / window.step;
  const auto last = static_cast<double>(window.segments() - 1);
  const auto segment = static_cast<std::size_t>(std::clamp(steps, 0.0, last));
  return {segment + 1, std::clamp(steps - static_cast<double>(segment), 0.0, 1.0)};
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
  for (std::size_t s = 0; s < sums.size(); ++s) sums[s].doubtful.add_to(doubtful, s);
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
  const auto [a, u] = place_of(instant_ns, window);
  const std::size_t b = a + 1;
  const Matrix6 between = full_covariance(a, b);
  // [K20]
  return (1.0 - u) * (1.0 - u) * full_covariance(a, a) + u * u * full_covariance(b, b) +
         u * (1.0 - u) * (between + between.transpose());
}

Twist KnotRegistration::held_back_at(std::int64_t instant_ns) const {
  const auto [a, u] = place_of(instant_ns, window);
  return (1.0 - u) * held_back[a] + u * held_back[a + 1];
}

double KnotRegistration::disagreement(double unseen_weight) const {
  return misfit - (1.0 - unseen_weight) * unseen;  // [K13]
}

double KnotRegistration::misfit_of_seen() const {
  return unseen < 1.0 ? (misfit - unseen) / (1.0 - unseen) : 1.0;
}

Annealing usual_annealing(const Config::Knots& config) {
  return {config.kernel_start, config.kernel_decay, config.max_iterations};
}

Annealing patient_annealing(const Config::Knots& config) {
  return {2.0 * config.kernel_start, std::sqrt(config.kernel_decay), 2 * config.max_iterations};
}

KnotRegistration register_knots(KnotPoints& points, const KnotProblem& problem,
                                const KnotWindow& start, const Annealing& annealing) {
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
                    wide ? wide_stride : 1};
    problem.workers.for_each(sums.size(), [&](std::size_t s) {
      sums[s] = sum_segment(points, s, problem, result.window, look);
    });
    problem.begin_step(Step::solve);
    BandedSystem surfels(start.knots.size());
    add_surfels(surfels, sums, result);
    BandedSystem system = surfels;
    const auto all = static_cast<double>(std::max<std::size_t>(points.points.size(), 1));
    result.misfit /= all;  // [K12]
    result.unseen = 1.0 - result.matches / all;
    problem.prior.add_to(system, result.window);
    problem.model.add_to(system, result.window, problem.prior.means[1].rotation);
    result.iterations = t;
    const BandedSystem assumed = system;
    result.solved = system.factorise();
    if (!result.solved) return result;
    const std::vector<Twist> steps = system.solve();
    const std::optional<double> change = move_knots(steps, result.window);
    result.solved = change.has_value();
    if (!result.solved) return result;
    result.converged = ratio <= 1.0 && *change < config.convergence;
    if (result.converged || t == annealing.max_iterations) {
      result.covariance = system.covariance();
      result.last_two = system.last_two_information();
      result.dependence = dependence_of(sums, result.rigid, config.independence);
      result.solved = count_in_full(assumed, surfels, sums, steps, config.independence, result);
      return result;
    }
    kernel *= annealing.decay;
  }
  return result;
}

}  // namespace surefoot
