// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace surefoot {

/// Thins a cloud to one point per cube of `voxel` [m]: the one nearest to the cube's centre. The
/// result does not depend on the order of the points, and is ordered by cube.
[[nodiscard]] std::vector<Eigen::Vector3f> downsample(const std::vector<Eigen::Vector3f>& points,
                                                      double voxel);

}  // namespace surefoot
