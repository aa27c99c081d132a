// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"

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

}  // namespace surefoot
