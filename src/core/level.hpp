// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surefoot/config.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// The plane that a scan stands on.
struct GroundPlane {
  Eigen::Vector3d normal;  ///< LiDAR frame, unit, upward
  double height;           ///< of the LiDAR above it [m]
};

/// The ground in a cloud (LiDAR frame [m]): the best-supported plane beneath the sensor, at most
/// `max_tilt_deg` from level in the LiDAR's frame, with hardly a point below it. None if no plane
/// is supported well enough.
[[nodiscard]] std::optional<GroundPlane> find_ground(const std::vector<Eigen::Vector3f>& points,
                                                     double max_tilt_deg);

/// The first pose T_map_lidar, such that the map's z axis points up, and how that was found out.
[[nodiscard]] Pose level_pose(const std::vector<Eigen::Vector3f>& points,
                              const Config::Level& config, LevelReport& report);

}  // namespace surefoot
