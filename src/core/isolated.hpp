// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"

namespace surefoot {

/// Indices, ascending, of the points (sensor's frame [m]) that have company: another point lies in
/// about the same direction at about the same range. A beam that met a raindrop, dust or another
/// sensor's light has none, while what surfaces return comes in crowds; thinned to a point per
/// cube, such strays would count as much as a wall does. Direction and range are cut into cells
/// that follow the scan's density, so that a sparse one is not all strays; should it be by half,
/// nothing can be told, and all are given. The order of the points does not matter.
[[nodiscard]] std::vector<std::uint32_t> points_with_company(
    const std::vector<Eigen::Vector3f>& points, const Workers& workers = Workers(1));

}  // namespace surefoot
