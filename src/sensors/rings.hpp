// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace surefoot::sensors {

/// Rings by elevation, 0 the lowest; equal elevations share one.
[[nodiscard]] inline std::vector<std::uint16_t> rings_of(const std::vector<double>& elevations) {
  std::vector<double> levels = elevations;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<std::uint16_t> rings;
  rings.reserve(elevations.size());
  for (const double elevation : elevations) {
    rings.push_back(static_cast<std::uint16_t>(
        std::lower_bound(levels.begin(), levels.end(), elevation) - levels.begin()));
  }
  return rings;
}

}  // namespace surefoot::sensors
