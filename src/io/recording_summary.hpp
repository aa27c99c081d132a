// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a recording holds, and what is odd about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

/// Smallest, middle and largest of some values; all zero where there are none.
struct Spread {
  double least = 0.0;
  double median = 0.0;
  double greatest = 0.0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// The median of the intervals between scans but the first: a capture begins somewhere within a
/// sweep, which the next one follows early.
[[nodiscard]] double usual_interval(const std::vector<double>& intervals);

/// Something odd, how often it occurs, and the first scan that has it.
struct Oddity {
  std::string what;
  std::size_t scans = 0;
  std::string first;
};

struct RecordingSummary {
  std::string description;
  std::vector<std::string> notes;
  std::vector<std::string> layouts;  ///< the different ones, in the order they occur
  std::size_t scans = 0;             ///< that could be read
  std::size_t unreadable = 0;
  Spread points;  ///< a scan
  std::int64_t first_stamp_ns = 0;
  std::int64_t last_stamp_ns = 0;
  Spread interval_s;  ///< between stamps of scans that follow each other
  double usual_interval_s = 0.0;
  Spread duration_s;  ///< from first to last point of a scan
  Spread range_m;     ///< of returns; the median is that of the scans' middle ranges
  Spread intensity;   ///< the median as for the range
  bool has_intensities = false;
  std::vector<std::uint16_t> rings;  ///< those that occur, ascending
  CaptureCounts capture;
  std::vector<Oddity> oddities;

  [[nodiscard]] double rate_hz() const {
    return usual_interval_s > 0.0 ? 1.0 / usual_interval_s : 0.0;
  }
};

/// Reads a recording to its end.
[[nodiscard]] RecordingSummary summarise(Recording& recording);

}  // namespace surefoot::io
