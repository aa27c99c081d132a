// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace surefoot::report {

/// Points that stand for a larger cloud.
struct ThinnedCloud {
  std::vector<std::uint32_t> kept;  ///< indices, ascending
  double cube = 0.0;                ///< [m] side of the cubes with one point each; 0: all are kept
};

/// At most `budget` of the points: the first one in each of equal cubes, which are as small as that
/// allows within about a tenth. Points that are not finite are left out. Throws
/// std::invalid_argument for a budget of zero or more points than 32 bits count.
[[nodiscard]] ThinnedCloud thin_cloud(std::span<const Eigen::Vector3f> points, std::size_t budget);

}  // namespace surefoot::report
