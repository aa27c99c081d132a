// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What of a recording a person should know before running it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "checks/scan_facts.hpp"
#include "io/recording.hpp"
#include "io/recording_summary.hpp"

namespace surefoot::checks {

struct Finding {
  bool suffers = false;   ///< a run suffers of it; else it is odd, and a run copes
  std::string what;       ///< "stamps go back"
  std::string detail;     ///< what it means, or what helps
  std::size_t scans = 0;  ///< that have it; 0: it is of the whole recording
  std::string first;      ///< the first of them
};

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

/// What is odd about the scans, what a run suffers of first. `losses`: what the recording says that
/// it could not read.
[[nodiscard]] std::vector<Finding> findings_of(const std::vector<ScanFacts>& scans,
                                               const Figures& figures,
                                               const io::CaptureCounts& counts,
                                               const std::vector<std::string>& losses = {});

}  // namespace surefoot::checks
