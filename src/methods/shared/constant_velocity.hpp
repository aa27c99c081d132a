// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "surefoot/pose.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// A scan's points in the LiDAR frame at normalised time `tau`, if the sensor moved by `motion`
/// (LiDAR frame) at constant velocity from the scan's first instant to its last. Points without
/// times stay where they are.
[[nodiscard]] std::vector<Eigen::Vector3d> deskew_to(double tau, const PreparedScan& scan,
                                                     const Twist& motion, const Workers& workers);

/// The same motion through the pose at normalised time `tau`.
[[nodiscard]] ScanTrajectory constant_velocity_through(const Pose& T_map_lidar, double tau,
                                                       const Twist& motion,
                                                       const PreparedScan& scan);

[[nodiscard]] std::vector<Eigen::Vector3f> to_float(const std::vector<Eigen::Vector3d>& points);

/// The points moved by a pose.
[[nodiscard]] std::vector<Eigen::Vector3d> transformed(const Pose& T,
                                                       const std::vector<Eigen::Vector3d>& points);

/// The points whose distance from the sensor lies between the two [m], both exclusive.
[[nodiscard]] std::vector<Eigen::Vector3d> crop(const std::vector<Eigen::Vector3d>& points,
                                                double min_range, double max_range);

}  // namespace surefoot
