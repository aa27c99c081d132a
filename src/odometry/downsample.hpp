// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "odometry/parallel.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// Thins a cloud to one point per cube of `voxel` [m]: the one nearest to the cube's centre. The
/// result does not depend on the order of the points; its own order is fixed, but not a spatial
/// one.
[[nodiscard]] std::vector<Eigen::Vector3f> downsample(const std::vector<Eigen::Vector3f>& points,
                                                      double voxel,
                                                      const Workers& workers = Workers(1));

/// Likewise, but tells which points are kept.
[[nodiscard]] std::vector<std::uint32_t> downsample_indices(
    const std::vector<Eigen::Vector3f>& points, double voxel, const Workers& workers = Workers(1));

/// A scan thinned for its two uses.
struct ThinnedScan {
  std::vector<Eigen::Vector3f> map_points;     ///< to enter the map
  std::vector<Eigen::Vector3f> source_points;  ///< to be registered; a subset of them
};

/// Thins by downsample.map_voxel and downsample.source_voxel. Where that leaves fewer than
/// downsample.min_points to register (a stairwell, a small room), both cubes are halved until it
/// does not, four times at most.
[[nodiscard]] ThinnedScan thin_scan(const std::vector<Eigen::Vector3f>& points,
                                    const Config::Downsample& config,
                                    const Workers& workers = Workers(1));

}  // namespace surefoot
