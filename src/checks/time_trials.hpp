// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the motion says about the point times: a stretch of the recording is run with the times as
// they are read and with other readings of them, and the sharper map is right.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surefoot/scan.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::checks {

/// Readings of a scan's point times.
enum class TimeReading {
  as_read,
  backward,         ///< they count back from the stamp: the sweep runs the other way
  none,             ///< all points are of one instant: the scan is deskewed already
  clockwise_front,  ///< from azimuth, a revolution that begins ahead (x), behind, either way
  clockwise_behind,
  counterclockwise_front,
  counterclockwise_behind
};
/// "as read", "counted back from the stamp", ...
[[nodiscard]] const char* name_of(TimeReading reading);
/// The flags that make a run read them so; empty for as_read.
[[nodiscard]] const char* flags_of(TimeReading reading);

/// One reading, tried.
struct TimeTrial {
  TimeReading reading = TimeReading::as_read;
  std::vector<double> blur;   ///< of each scan [m], NaN where there is none
  double middle_blur = 0.0;   ///< their median [m]
  std::size_t worse = 0;      ///< scans that are blurred more than with the first trial's reading
  std::size_t better = 0;     ///< and less
  double chance = 1.0;        ///< that so uneven a count comes of readings that are equally good
  std::size_t untrusted = 0;  ///< scans that were not registered, or with which a map began anew
  Trajectory trajectory;      ///< of those that were
};

struct TimeTrials {
  std::vector<TimeTrial> trials;  ///< the first one is that of the times as they are read
  std::size_t scans = 0;          ///< of the stretch
  std::size_t preferred = 0;      ///< trial; the first where none is clearly better
  bool decided = false;           ///< the preferred one is clearly better than all others
};

/// Tries readings of the scans' times: those that apply, all where scans that look around have no
/// times. `period_ns`: between scans.
[[nodiscard]] TimeTrials try_times(const std::vector<Scan>& scans, std::int64_t period_ns,
                                   bool looks_around, int threads);

/// Prefers what is clearly better than the first, and the sharpest of those that are; or the first,
/// where it is clearly better than every other: what is no chance, and makes a difference.
void choose(TimeTrials& result);

/// Chance of a count at least as uneven as `a` against `b` from a fair coin.
[[nodiscard]] double chance_of(std::size_t a, std::size_t b);

}  // namespace surefoot::checks
