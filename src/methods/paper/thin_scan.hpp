// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/parallel.hpp"
#include "methods/paper/paper_parameters.hpp"

namespace surefoot {

/// A scan thinned for its two uses.
struct ThinnedScan {
  std::vector<Eigen::Vector3f> map_points;     ///< to enter the map
  std::vector<Eigen::Vector3f> source_points;  ///< to be registered; a subset of them
};

/// Thins by downsample.map_voxel and downsample.source_voxel. Where that leaves fewer than
/// downsample.min_points to register (a stairwell, a small room), both cubes are halved until it
/// does not, four times at most.
[[nodiscard]] ThinnedScan thin_scan(const std::vector<Eigen::Vector3f>& points,
                                    const PaperParameters::Downsample& config,
                                    const Workers& workers = Workers(1));

}  // namespace surefoot
