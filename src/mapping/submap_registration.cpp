// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/submap_registration.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/decompositions.hpp"
#include "geometry/so3.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kMostPoints = 2400;
constexpr std::size_t kMostStanding = 4000;
constexpr int kIterations = 15;         // a grid
constexpr double kConverged = 2e-4;     // [m, rad / kLever]
constexpr double kKernel = 0.2;         // of a grid's cubes
constexpr double kOnIt = 0.2;           // points nearer than this lie on a surface [m]
constexpr double kNoise = 0.03;         // of a residual, at least [m]
constexpr double kIndependence = 0.05;  // share of the residuals that count as independent
constexpr double kFloor = 0.015;        // of an alignment: pieces are bent a little themselves [m]
constexpr double kHeld = 0.05;  // information of a direction, of that of all points along it

/// Every n-th, so that about `count` are left.
void pick(const std::vector<Eigen::Vector3d>& from, std::size_t count,
          std::vector<Eigen::Vector3d>& to) {
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

Equations linearise(const GaussianGrid& grid, const std::vector<Eigen::Vector3d>& points,
                    const Pose& pose, double kernel) {
  Equations sum;
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  const double kernel2 = kernel * kernel;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d place = R * point + pose.translation;
    const Gaussian* gaussian = grid.find(place);
    if (gaussian == nullptr) continue;
    const Eigen::Vector3d difference = place - gaussian->mean;
    const Eigen::Vector3d counted = gaussian->across * difference;
    const double squared = difference.dot(counted);
    const double root = kernel2 / (kernel2 + squared);
    const double weight = root * root;
    Eigen::Matrix<double, 3, 6> J;
    J.leftCols<3>() = R;
    J.rightCols<3>() = -R * hat(point);
    const Eigen::Matrix<double, 3, 6> AJ = gaussian->across * J;
    sum.H.noalias() += weight * J.transpose() * AJ;
    sum.b.noalias() += weight * J.transpose() * counted;
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
  for (const double size : kSizes) grids_.emplace_back(submap.points, size);
  std::vector<Eigen::Vector3d> lying, standing;
  for (const Eigen::Vector3f& point : submap.points) {
    const Eigen::Vector3d at = point.cast<double>();
    const Gaussian* surface = grids_[2].inside(at);
    if (surface == nullptr) surface = grids_[1].inside(at);
    if (surface == nullptr) surface = grids_[0].inside(at);
    if (surface == nullptr) continue;
    (surface->level ? lying : standing).push_back(at);
  }
  standing_count_ = standing.size();
  pick(standing, kMostStanding, standing_);
  pick(standing, kMostPoints / 2, points_);
  pick(lying, kMostPoints - points_.size(), points_);
}

SubmapAlignment align_submaps(const RegistrationSubmap& target, const RegistrationSubmap& source,
                              const Pose& start, std::size_t first_level, std::size_t levels) {
  SubmapAlignment result;
  result.T_target_source = start;
  const Twist s = scale();
  for (std::size_t level = first_level; level < levels; ++level) {
    const GaussianGrid& grid = target.grid(level);
    // Wide at first: what is right may lie a cube away.
    double kernel = kKernel * grid.size() * 2.0;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      const Equations equations = linearise(grid, source.points(), result.T_target_source, kernel);
      kernel = std::max(0.8 * kernel, kKernel * grid.size());
      if (equations.weights < 20.0) return result;
      Matrix6 damped = s.asDiagonal() * equations.H * s.asDiagonal();
      damped.diagonal().array() += 1e-3 * equations.weights;  // what nothing holds stays
      const Twist step = s.cwiseProduct(-damped.ldlt().solve(s.cwiseProduct(equations.b)).eval());
      if (!step.allFinite()) return result;
      result.T_target_source = result.T_target_source * se3_exp(step);
      if (step.cwiseQuotient(s).norm() < kConverged) break;
    }
  }
  const GaussianGrid& finest = target.grid(levels - 1);
  assess(linearise(finest, source.points(), result.T_target_source, kKernel * finest.size()),
         result);
  double squares = 0.0;
  std::size_t matched = 0;
  for (const Eigen::Vector3d& point : source.standing()) {
    const Eigen::Vector3d place = result.T_target_source * point;
    const Gaussian* gaussian = finest.find(place);
    if (gaussian == nullptr) continue;
    const Eigen::Vector3d difference = place - gaussian->mean;
    const double squared = difference.dot(gaussian->across * difference);
    if (squared > kOnIt * kOnIt) continue;
    ++matched;
    squares += squared;
  }
  result.matched = static_cast<double>(matched) /
                   static_cast<double>(std::max<std::size_t>(source.standing().size(), 1));
  result.misfit = matched > 0 ? std::sqrt(squares / static_cast<double>(matched)) : 0.0;
  return result;
}

AlignmentGap gap_between(const SubmapAlignment& alignment, const Pose& other) {
  const Twist s = scale();
  const Twist gap = se3_log(alignment.T_target_source.inverse() * other).cwiseQuotient(s);
  const auto held = alignment.axes.leftCols(alignment.held);
  const Twist counted = s.cwiseProduct((held * (held.transpose() * gap)).eval());
  return {counted.head<3>().norm(), counted.tail<3>().norm() * 180.0 / std::numbers::pi};
}

}  // namespace surefoot::mapping
