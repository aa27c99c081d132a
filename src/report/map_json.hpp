// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "report/report.hpp"

namespace surefoot::report {

/// The map, thinned to `budget` points, its coordinates in 65536 steps an axis between `low` and
/// `high` [m]; intensities in 256 steps, times in 65536. Null for a map without points.
[[nodiscard]] nlohmann::ordered_json map_json(const MapCloud& map, std::size_t budget);

/// Coordinates in 65536 steps an axis between `low` and `high` [m]; at least one point.
[[nodiscard]] nlohmann::ordered_json points_json(const std::vector<Eigen::Vector3f>& points);

}  // namespace surefoot::report
