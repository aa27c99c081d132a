// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is seen of one scan, for a look at a whole recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/point_time_watch.hpp"
#include "io/recording.hpp"
#include "io/repeated_scans.hpp"

namespace surefoot::checks {

/// Who sees so much of the directions around spins: no pauses between sweeps, times by azimuth.
inline constexpr double kLooksAround = 0.8;

struct ScanFacts {
  std::string name;
  std::string error;   ///< why it could not be read; empty: it could, else the rest is zero
  std::string remark;  ///< "partial revolution"
  std::int64_t stamp_ns = 0;
  std::int64_t logged_ns = 0;  ///< when its message was received; 0: not known
  /// Its stamp as a run mends it; nothing where that is as it is stored.
  std::optional<std::int64_t> mended_ns;
  std::optional<io::PointClock> clock;
  std::size_t points = 0;
  std::size_t returns = 0;     ///< finite and not zero
  std::size_t not_finite = 0;  ///< points
  std::size_t zero = 0;
  std::size_t untimed = 0;  ///< points that were left out for want of a usable time
  io::PointTimes times = io::PointTimes::none;
  double first_s = 0.0;  ///< point times, from the stamp
  double last_s = 0.0;
  double nearest = 0.0;  ///< ranges of the returns [m]
  double middle = 0.0;
  double farthest = 0.0;
  bool at_one_height = false;        ///< its returns: z tells nothing
  std::vector<std::uint16_t> rings;  ///< that have returns, ascending
  double seen_around = 0.0;          ///< share of the directions around with returns
  std::optional<io::Spin> spin;
  double turned_deg = 0.0;  ///< about the sensor's z axis since the scan before, roughly
  bool sent_again = false;  ///< the last scan's points, or those that came at its stamp before
};

/// Looks at scans in the order of the recording.
class ScanLooker {
 public:
  [[nodiscard]] ScanFacts look(const io::ScanItem& item);

 private:
  std::vector<double> profile_;  ///< of the last scan: mean logarithm of the range, by direction
  std::uint64_t last_points_ = 0;
  io::SeenScans seen_;
};

}  // namespace surefoot::checks
