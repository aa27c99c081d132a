// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace surefoot {

/// Thins a cloud to the mean of the points in every cell of `size` [m], as PCL's VoxelGrid
/// does; in the order in which the cells first occur.
[[nodiscard]] std::vector<Eigen::Vector3d> mean_downsample(
    const std::vector<Eigen::Vector3d>& points, double size);

}  // namespace surefoot
