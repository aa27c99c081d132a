// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace surefoot {

/// One sweep of a LiDAR, eq. (1): points with the instants at which they were measured.
///
/// Structure of arrays: every optional array is either empty or as long as `points`.
/// Points that are NaN, infinite or within a millimetre of zero are "no return" and are skipped by
/// the odometry. Their times count: the first and the last of all tell when the sweep began and
/// ended, whatever it saw.
struct Scan {
  std::int64_t stamp_ns = 0;            ///< instant that `times_ns` counts from; sensor's epoch
  std::vector<Eigen::Vector3f> points;  ///< [m], LiDAR frame: x forward, y left, z up
  std::vector<float> intensities;       ///< as the sensor gives them
  std::vector<std::int32_t> times_ns;   ///< point's instant minus stamp_ns; empty: no point times
  std::vector<std::uint16_t> rings;     ///< laser, counted from the lowest
};

}  // namespace surefoot
