// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which instant of a sweep its stamp names. The scans alone cannot tell: all of a run moved by a
// tenth of a second is as good a run. Something else that was measured by the same clock can: a
// gyroscope in the bag, or a true trajectory.
#pragma once

#include <cstddef>

#include "surefoot/trajectory.hpp"

namespace surefoot::checks {

struct StampLag {
  std::size_t pairs = 0;              ///< motions from pose to pose that were compared
  double lag_s = 0.0;                 ///< added to the stamps, they fit best
  double error_deg = 0.0;             ///< RMS difference of the turns with the stamps as they are
  double best_deg = 0.0;              ///< and with the lag
  std::size_t better = 0, worse = 0;  ///< motions that fit better with the lag, and worse
  double chance = 1.0;                ///< that so uneven a count means nothing
};

/// Compares turns of `estimate` with those of `reference` at stamps that are moved by up to
/// `most_s`; only angles count, so that neither frame nor mounting matters.
[[nodiscard]] StampLag find_stamp_lag(const Trajectory& estimate, const Trajectory& reference,
                                      double most_s);

}  // namespace surefoot::checks
