// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "baselines/cell_index.hpp"

namespace surefoot {

/// Hash of a cell's index.
using CellHash = std::uint32_t (*)(const VoxelIndex&);

/// Thins a cloud to the first point of every cell of `size` [m].
///
/// The result comes in the order in which a robin-hood hash table (tsl::robin_map with room for all
/// points) walks over its cells. KISS-ICP and its descendants thin with such a table, and their
/// maps keep the points that come first: the order is part of what they compute.
[[nodiscard]] std::vector<Eigen::Vector3d> cell_downsample(
    const std::vector<Eigen::Vector3d>& points, double size, CellRounding rounding, CellHash hash);

}  // namespace surefoot
