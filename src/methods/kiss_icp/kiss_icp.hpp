// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/parallel.hpp"
#include "methods/kiss_icp/kiss_icp_parameters.hpp"
#include "methods/shared/alignment.hpp"
#include "methods/shared/voxel_map.hpp"

namespace surefoot {

/// The two thinned clouds of KISS-ICP.
struct KissClouds {
  std::vector<Eigen::Vector3d> frame_downsample;  ///< enters the map
  std::vector<Eigen::Vector3d> source;            ///< of these, registered
};

/// One point per cell of half the map's voxel, and of these one per cell of 1.5 voxels.
[[nodiscard]] KissClouds voxelize(const std::vector<Eigen::Vector3d>& points, double voxel_size);

/// KISS-ICP's registration: point to point with the nearest map point, Geman-McClure weighted with
/// scale `sigma` [m], matches up to 3 sigma apart.
[[nodiscard]] Alignment align_points_to_map(const std::vector<Eigen::Vector3d>& source,
                                            const VoxelMap& map, const Pose& initial_guess,
                                            double sigma, const KissIcpParameters& config,
                                            const Workers& workers);

}  // namespace surefoot
