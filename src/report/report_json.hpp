// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "report/report.hpp"

namespace surefoot::report {

/// A single map is thinned to this many points, and all maps together to kMostMapPoints.
inline constexpr std::size_t kMapPoints = 400'000;
inline constexpr std::size_t kMostMapPoints = 1'000'000;

/// The report as the page reads it (docs/report.md): JSON that may stand inside a script element;
/// series and maps are base64 of little-endian numbers. Times are seconds after the recording's
/// first stamp. Bytes that are not UTF-8 are replaced. `map_points`: of each map at most; 0: the
/// limits above. Throws std::invalid_argument where vectors that belong together differ in length.
[[nodiscard]] std::string to_json(const Report& report, std::size_t map_points = 0);

}  // namespace surefoot::report
