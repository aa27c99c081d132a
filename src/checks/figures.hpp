// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the scans of a recording have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "checks/scan_facts.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

/// Figures over all scans that could be read.
struct Figures {
  std::size_t scans = 0;
  std::size_t unreadable = 0;
  std::int64_t first_stamp_ns = 0;
  std::int64_t last_stamp_ns = 0;
  io::Spread interval_s;          ///< between stamps as they are stored
  double usual_interval_s = 0.0;  ///< the median of those that go forward
  io::Spread points;
  io::Spread returns;
  double not_finite_share = 0.0;  ///< of all points
  double zero_share = 0.0;
  io::Spread duration_s;    ///< of a sweep
  io::Spread first_time_s;  ///< first point's time after the stamp
  io::Spread last_time_s;
  io::Spread range_m;  ///< nearest, middle one's median, farthest
  io::Spread around;   ///< share of the directions around that a scan has returns in
  std::vector<std::uint16_t> rings;
  double turned_deg = 0.0;  ///< all turns about z, either way, roughly

  [[nodiscard]] double rate_hz() const {
    return usual_interval_s > 0.0 ? 1.0 / usual_interval_s : 0.0;
  }
};

[[nodiscard]] Figures figures_of(const std::vector<ScanFacts>& scans);

}  // namespace surefoot::checks
