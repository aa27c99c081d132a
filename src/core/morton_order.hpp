// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace surefoot {

/// Puts the indices of points [m] in an order in which what is near in space is mostly near: along
/// Morton's curve through 1024 cells each way. Whoever then goes through a map finds most of what
/// it asks for in the caches. Points of one cell stay in the order they had.
void sort_along_morton_curve(const std::vector<Eigen::Vector3f>& points,
                             std::vector<std::uint32_t>& indices);

}  // namespace surefoot
