// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/normal_equations.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// What a baseline's registration found.
struct Alignment {
  Pose T_map_lidar;
  int points = 0;      ///< that were to be registered
  int iterations = 0;  ///< updates that were solved and applied
  bool converged = false;
  bool finite = true;            ///< false: it ended without numbers, T_map_lidar is from before
  NormalEquations<6> equations;  ///< the last ones, for a twist about the map's origin
  std::string refusal;  ///< why the original would not use it; then T_map_lidar is the prediction
};

/// w = k^2 / (k + |r|^2)^2: the kernel of KISS-ICP and its descendants, their scale k [m] (its unit
/// does not fit r^2 [m^2]; so do the originals).
[[nodiscard]] inline double geman_mcclure_weight(double squared_residual, double kernel) {
  const double ratio = kernel / (kernel + squared_residual);
  return ratio * ratio;
}

/// Sums of point-to-point residuals s - q, s in the map: the equations of J = [I, -hat(s)], summed
/// without writing J down.
struct PointToPointSum {
  double weight = 0.0;
  double weighted_squares = 0.0;
  int count = 0;
  Eigen::Vector3d s = Eigen::Vector3d::Zero();
  Eigen::Matrix3d ss = Eigen::Matrix3d::Zero();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  Eigen::Vector3d sxr = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& source, const Eigen::Vector3d& target, double w) {
    const Eigen::Vector3d residual = source - target;
    weight += w;
    weighted_squares += w * residual.squaredNorm();
    ++count;
    s += w * source;
    ss.noalias() += w * source * source.transpose();
    r += w * residual;
    sxr += w * source.cross(residual);
  }
  PointToPointSum& operator+=(const PointToPointSum& other);
  [[nodiscard]] NormalEquations<6> equations() const;
};

/// Solves the normal equations as the originals do, by LDL^T: a direction without information
/// stays where it is.
[[nodiscard]] Twist solve_ldlt(const NormalEquations<6>& equations);

/// The loop of KISS-ICP and its descendants: solve, move, until an update's norm is below
/// `convergence`. build(points, update) moves the points by the update, in place, and returns the
/// next equations.
template <typename Build>
[[nodiscard]] Alignment align(std::vector<Eigen::Vector3d> points, const Pose& initial_guess,
                              int max_iterations, double convergence, const Build& build) {
  Alignment result;
  result.points = static_cast<int>(points.size());
  Pose update = initial_guess;  // not yet applied to the points
  Pose T_icp;
  while (result.iterations < max_iterations && !result.converged) {
    result.equations = build(points, update);
    const Twist dx = solve_ldlt(result.equations);
    result.finite = dx.allFinite();
    if (!result.finite) break;
    update = se3_exp(dx);
    T_icp = update * T_icp;
    ++result.iterations;
    result.converged = dx.norm() < convergence;
  }
  result.T_map_lidar = result.finite ? T_icp * initial_guess : initial_guess;
  return result;
}

}  // namespace surefoot
