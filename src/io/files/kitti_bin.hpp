// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "io/point_table.hpp"

namespace surefoot::io {

/// KITTI's Velodyne scans: float32 x y z intensity a point, nothing else, no point times; or
/// nuScenes', which have the laser's number, too: found out from the values. The table looks into
/// `file`. Throws ReadError where it is neither.
[[nodiscard]] PointTable parse_kitti_bin(std::span<const std::byte> file);

/// Turns each point up by 0.205 deg about the sensor: the known error of KITTI's HDL-64E intrinsics
/// (Deschaud 2018, "IMLS-SLAM", and every KITTI odometry since).
void correct_kitti_hdl64(std::vector<Eigen::Vector3f>& points);

}  // namespace surefoot::io
