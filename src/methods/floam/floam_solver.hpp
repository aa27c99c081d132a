// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// A feature point and the line or plane of the map that it should lie on.
struct FloamResidual {
  enum class Kind { edge, surface };
  Kind kind;
  Eigen::Vector3d point;      // LiDAR frame
  Eigen::Vector3d anchor;     // edge: a point of the line
  Eigen::Vector3d direction;  // edge: unit direction of the line; surface: unit normal
  double offset = 0.0;        // surface: the plane is direction . x + offset = 0
};

/// The residual [m] of a point placed in the map.
[[nodiscard]] double floam_residual(const FloamResidual& residual, const Eigen::Vector3d& placed);
/// Its derivative by a twist about the map's origin that moves the placed point. Zero for a point
/// on its line, where there is none.
[[nodiscard]] Eigen::Matrix<double, 1, 6> floam_jacobian(const FloamResidual& residual,
                                                         const Eigen::Vector3d& placed);

/// The line through five neighbours, unless they are no line: then false.
[[nodiscard]] bool fit_line(std::span<const Eigen::Vector3d, 5> neighbours,
                            FloamResidual& residual);
/// The plane through five neighbours, unless they are no plane. `centred`: about their mean; else
/// as the original, which solves n . x = -1 and cannot represent planes through the map's origin.
[[nodiscard]] bool fit_plane(std::span<const Eigen::Vector3d, 5> neighbours, bool centred,
                             FloamResidual& residual);

/// What Ceres' trust-region minimiser gives for these residuals under its Huber loss of 0.1 m, with
/// the options that F-LOAM sets: Levenberg-Marquardt, at most four steps.
struct FloamSolution {
  Pose T_map_lidar;
  NormalEquations<6> equations;  ///< at the last accepted pose
  int steps = 0;                 ///< accepted
  bool converged = false;        ///< ended by a tolerance, not by the number of steps
};
[[nodiscard]] FloamSolution solve_floam(const std::vector<FloamResidual>& residuals,
                                        const Pose& T_map_lidar, const Workers& workers);

}  // namespace surefoot
