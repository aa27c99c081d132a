// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "methods/shared/cell_index.hpp"

namespace surefoot {

/// Hash of a cell's index.
using CellHash = std::uint32_t (*)(const VoxelIndex&);

/// The first point of every cell of `size` [m], by its index.
///
/// They come in the order in which a robin-hood hash table (tsl::robin_map, told to expect so many
/// cells; it doubles when half full) walks over its cells. KISS-ICP and its descendants thin with
/// such a table, and so does CT-ICP; their maps keep the points that come first: the order is part
/// of what they compute.
[[nodiscard]] std::vector<std::uint32_t> first_of_cells(const std::vector<Eigen::Vector3d>& points,
                                                        double size, CellRounding rounding,
                                                        CellHash hash, std::size_t expected_cells);

/// Thins a cloud to these points, by a table that expects as many cells as points.
[[nodiscard]] std::vector<Eigen::Vector3d> cell_downsample(
    const std::vector<Eigen::Vector3d>& points, double size, CellRounding rounding, CellHash hash);

}  // namespace surefoot
