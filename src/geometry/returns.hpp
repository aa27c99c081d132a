// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What of a scan's points was measured, and what only stands for nothing.
#pragma once

#include <Eigen/Core>
#include <limits>

namespace surefoot {

/// [m] No LiDAR measures so near: drivers that have no return write zero, some with an offset of
/// less than a millimetre, or what rounding left of it.
inline constexpr double kNoRange = 1e-3;

/// Whether a point of this squared range [m^2] is a return.
[[nodiscard]] inline bool is_return(double squared_range) {
  return squared_range >= kNoRange * kNoRange &&
         squared_range <= std::numeric_limits<double>::max();  // NaN fails both
}
/// NaN, infinite and zero are none. Asked once and again for every point.
[[nodiscard, gnu::always_inline]] inline bool is_return(const Eigen::Vector3f& point) {
  const auto x = static_cast<double>(point.x()), y = static_cast<double>(point.y()),
             z = static_cast<double>(point.z());
  return is_return(x * x + y * y + z * z);
}

}  // namespace surefoot
