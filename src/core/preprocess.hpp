// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "surefoot/config.hpp"
#include "surefoot/scan.hpp"

namespace surefoot {

/// The valid points of a scan with their normalised times, eq. (1).
struct PreparedScan {
  std::int64_t start_ns = 0;  ///< first and last instant of the scan
  std::int64_t end_ns = 0;
  std::vector<Eigen::Vector3f> points;  ///< [m] LiDAR frame, as measured
  std::vector<float> taus;              ///< tau_i in [0, 1]; empty if the scan has no point times
  std::vector<float> intensities;       ///< empty or one per point
  std::vector<std::uint16_t> rings;     ///< likewise; lasers counted from the lowest
  std::string rejection;                ///< why the scan cannot be used; empty if it can

  [[nodiscard]] std::int64_t mid_ns() const { return start_ns + (end_ns - start_ns) / 2; }
};

/// Drops points that are no returns or out of range and normalises the times, eq. (1).
[[nodiscard]] PreparedScan preprocess(const Scan& scan, const Config::Preprocess& config);

}  // namespace surefoot
