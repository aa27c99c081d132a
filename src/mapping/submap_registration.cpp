// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/submap_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/decompositions.hpp"
#include "geometry/so3.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kMostPoints = 2400;
constexpr std::size_t kMostStanding = 4000;
constexpr int kIterations = 15;             // a grid
constexpr double kConverged = 2e-4;         // [m, rad / kLever]
constexpr double kRoughlyConverged = 5e-3;  // where a finer grid comes after [m, rad / kLever]
constexpr double kSamePartners = 0.01;  // points that moved less lie on the same as before, cubes
constexpr double kLeastWeight = 0.01;   // of the points
constexpr std::size_t kRoughShare = 4;
constexpr double kKernel = 0.2;         // of a grid's cubes
constexpr double kOnIt = 0.2;           // points nearer than this lie on a surface [m]
constexpr double kNoise = 0.03;         // of a residual, at least [m]
constexpr double kIndependence = 0.05;  // share of the residuals that count as independent
constexpr double kFloor = 0.04;         // of an alignment: pieces are bent a little themselves [m]
constexpr double kHeld = 0.05;  // information of a direction, of that of all points along it

/// Every n-th, so that about `count` are left.
void pick(const std::vector<SubmapPoint>& from, std::size_t count, std::vector<SubmapPoint>& to) {
  const double every = std::max(1.0, static_cast<double>(from.size()) / static_cast<double>(count));
  for (double at = 0.0; at < static_cast<double>(from.size()); at += every) {
    to.push_back(from[static_cast<std::size_t>(at)]);
  }
}

struct Equations {
  Matrix6 H = Matrix6::Zero();
  Twist b = Twist::Zero();
  double weights = 0.0;
  double squares = 0.0;
};

/// What each point lies on; null: on nothing.
using Partners = std::vector<const Gaussian*>;

Partners find_partners(const GaussianGrid& grid, const std::vector<SubmapPoint>& points,
                       const Pose& pose) {
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  Partners result;
  result.reserve(points.size());
  for (const SubmapPoint& point : points) {
    const Gaussian* gaussian = grid.find(R * point.at + pose.translation);
    const bool other = gaussian != nullptr && gaussian->other_side(R * point.to_eye);
    result.push_back(other ? nullptr : gaussian);
  }
  return result;
}

Equations linearise(const Partners& partners, const std::vector<SubmapPoint>& points,
                    const Pose& pose, double kernel) {
  Equations sum;
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  const double kernel2 = kernel * kernel;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Gaussian* gaussian = partners[i];
    if (gaussian == nullptr) continue;
    const Eigen::Vector3d& point = points[i].at;
    const Eigen::Vector3d place = R * point + pose.translation;
    const double squared = gaussian->distance2(place);
    const double root = kernel2 / (kernel2 + squared);
    const double weight = root * root;
    for (int k = 0; k < gaussian->counted; ++k) {
      const Eigen::Vector3d& across = gaussian->across[static_cast<std::size_t>(k)];
      const Eigen::Vector3d axis = R.transpose() * across;
      Twist j;
      j << axis, point.cross(axis);
      sum.H.noalias() += (weight * j) * j.transpose();
      sum.b.noalias() += weight * across.dot(place - gaussian->mean) * j;
    }
    sum.weights += weight;
    sum.squares += weight * squared;
  }
  return sum;
}

Twist scale() {
  Twist result;
  result << 1.0, 1.0, 1.0, 1.0 / kLever, 1.0 / kLever, 1.0 / kLever;
  return result;
}

/// What the equations hold, and how well.
void assess(const Equations& equations, SubmapAlignment& alignment) {
  const Twist s = scale();
  const Matrix6 scaled = s.asDiagonal() * equations.H * s.asDiagonal();
  const SymmetricEigen<6> eigen = symmetric_eigen(scaled);
  const double variance =
      std::max(kNoise * kNoise, equations.squares / std::max(equations.weights, 1.0));
  alignment.information.setZero();
  alignment.held = 0;
  int free = 5;
  for (int i = 5; i >= 0; --i) {  // the best held first
    const double value = eigen.values[i];
    const Twist axis = eigen.vectors.col(i);
    if (value < kHeld * equations.weights / 3.0) {
      alignment.axes.col(free--) = axis;
      continue;
    }
    alignment.axes.col(alignment.held++) = axis;
    const double spread = variance / (kIndependence * value) + kFloor * kFloor;
    const Twist unscaled = axis.cwiseQuotient(s);
    alignment.information += unscaled * unscaled.transpose() / spread;
  }
}

}  // namespace

RegistrationSubmap::RegistrationSubmap(const Submap& submap) {
  for (const double size : kSizes) grids_.emplace_back(submap.points, submap.eyes, size);
  std::vector<SubmapPoint> lying, standing;
  for (std::size_t i = 0; i < submap.points.size(); ++i) {
    const Eigen::Vector3d at = submap.points[i].cast<double>();
    const Gaussian* surface = grids_[2].inside(at);
    std::optional<double> off2;
    if (surface != nullptr) off2 = surface->distance2(at);
    if (surface == nullptr) surface = grids_[1].inside(at);
    if (surface == nullptr) surface = grids_[0].inside(at);
    if (surface == nullptr) continue;
    const Eigen::Vector3d to_eye = (submap.eyes[i].cast<double>() - at).normalized();
    (surface->level ? lying : standing).push_back({at, to_eye, off2});
  }
  standing_count_ = standing.size();
  pick(standing, kMostStanding, standing_);
  pick(lying, kMostStanding, lying_);
  pick(standing, kMostPoints / 2, points_);
  pick(lying, kMostPoints - points_.size(), points_);
}

namespace {

/// Moves the pose until the points lie on the grid as well as they can. False if too few do.
bool descend(const GaussianGrid& grid, const std::vector<SubmapPoint>& points, Pose& pose,
             double converged) {
  const Twist s = scale();
  // Wide at first: what is right may lie a cube away.
  double kernel = kKernel * grid.size() * 2.0;
  double moved = std::numeric_limits<double>::infinity();  // since partners were looked for [m]
  Partners partners;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    if (moved > kSamePartners * grid.size()) {
      partners = find_partners(grid, points, pose);
      moved = 0.0;
    }
    const Equations equations = linearise(partners, points, pose, kernel);
    const bool narrow = kernel <= kKernel * grid.size();
    kernel = std::max(0.8 * kernel, kKernel * grid.size());
    if (equations.weights < kLeastWeight * static_cast<double>(points.size())) return false;
    Matrix6 damped = s.asDiagonal() * equations.H * s.asDiagonal();
    damped.diagonal().array() += 1e-3 * equations.weights;  // what nothing holds stays
    const Twist step = s.cwiseProduct(-damped.ldlt().solve(s.cwiseProduct(equations.b)).eval());
    if (!step.allFinite()) return false;
    pose = pose * se3_exp(step);
    const double size = step.cwiseQuotient(s).norm();
    moved += size;
    if (narrow && size < converged) break;
  }
  return true;
}

/// Every so manieth: enough to see which start is the best.
std::vector<SubmapPoint> some_of(const std::vector<SubmapPoint>& points) {
  std::vector<SubmapPoint> result;
  pick(points, points.size() / kRoughShare, result);
  return result;
}

/// How many of the points lie on something of the target, and how much farther off than at home.
struct Overlap {
  double share = 0.0;
  double misfit = 0.0;  // [m]
};
Overlap measure_overlap(const GaussianGrid& grid, const std::vector<SubmapPoint>& points,
                        const Pose& pose) {
  double squares = 0.0;
  double at_home = 0.0;  // squares
  std::size_t matched = 0;
  std::size_t dense = 0;  // of these, at home
  const Partners partners = find_partners(grid, points, pose);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (partners[i] == nullptr) continue;
    const double squared = partners[i]->distance2(pose * points[i].at);
    if (squared > kOnIt * kOnIt) continue;
    ++matched;
    if (!points[i].off2) continue;
    ++dense;
    squares += squared;
    at_home += *points[i].off2;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(points.size(), 1));
  const auto m = static_cast<double>(std::max<std::size_t>(dense, 1));
  return {static_cast<double>(matched) / n, std::sqrt(squares / m) - std::sqrt(at_home / m)};
}

void measure_standing(const GaussianGrid& grid, const std::vector<SubmapPoint>& standing,
                      SubmapAlignment& alignment) {
  const Overlap overlap = measure_overlap(grid, standing, alignment.T_target_source);
  alignment.matched = overlap.share;
  alignment.misfit = overlap.misfit;
}

}  // namespace

SubmapAlignment align_roughly(const RegistrationSubmap& target, const RegistrationSubmap& source,
                              const Pose& start) {
  SubmapAlignment result;
  result.T_target_source = start;
  if (descend(target.grid(0), some_of(source.points()), result.T_target_source,
              kRoughlyConverged)) {
    measure_standing(target.grid(0), some_of(source.standing()), result);
  }
  return result;
}

SubmapAlignment align_submaps(const RegistrationSubmap& target, const RegistrationSubmap& source,
                              const Pose& start, std::size_t first_level) {
  constexpr std::size_t kLast = RegistrationSubmap::kSizes.size() - 1;
  SubmapAlignment result;
  result.T_target_source = start;
  Pose& pose = result.T_target_source;
  for (std::size_t level = first_level; level <= kLast; ++level) {
    const double converged = level == kLast ? kConverged : kRoughlyConverged;
    if (!descend(target.grid(level), source.points(), pose, converged)) return result;
  }
  const GaussianGrid& finest = target.grid(kLast);
  assess(linearise(find_partners(finest, source.points(), pose), source.points(), pose,
                   kKernel * finest.size()),
         result);
  measure_standing(finest, source.standing(), result);
  result.level = measure_overlap(finest, source.lying(), pose).share;
  return result;
}

double overlap_between(const RegistrationSubmap& one, const RegistrationSubmap& other,
                       const Pose& T_one_other) {
  constexpr std::size_t kLast = RegistrationSubmap::kSizes.size() - 1;
  return std::min(measure_overlap(one.grid(kLast), other.standing(), T_one_other).share,
                  measure_overlap(other.grid(kLast), one.standing(), T_one_other.inverse()).share);
}

AlignmentGap gap_between(const SubmapAlignment& alignment, const Pose& other) {
  const Twist s = scale();
  const Twist gap = se3_log(alignment.T_target_source.inverse() * other).cwiseQuotient(s);
  const auto held = alignment.axes.leftCols(alignment.held);
  const Twist counted = s.cwiseProduct((held * (held.transpose() * gap)).eval());
  return {counted.head<3>().norm(), counted.tail<3>().norm() * 180.0 / std::numbers::pi};
}

}  // namespace surefoot::mapping
