// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans whose points do not say when they were measured: said aloud, since nothing can be deskewed
// then, and mended where the LiDAR spins and the user says how.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "io/recording.hpp"

namespace surefoot::io {

/// What the points of a scan tell about time.
enum class PointTimes {
  there,
  none,   ///< no field of times
  equal,  ///< one instant for all: the driver left the field empty
};
[[nodiscard]] PointTimes point_times_of(const Scan& scan);

/// The way that a scan's azimuth runs with its points' times, seen from above (z towards the
/// viewer); nothing where no direction shows (no times, or no spinning LiDAR).
[[nodiscard]] std::optional<Spin> spin_of(const Scan& scan);

/// How a spinning LiDAR swept.
struct SweepTiming {
  Spin spin = Spin::clockwise;
  double cut_deg = 0.0;        ///< direction of the first point, counter-clockwise from x
  std::int64_t period_ns = 0;  ///< of a revolution
  StampAt stamp_at = StampAt::automatic;
};
/// Point times from azimuths: the sweep begins at the cut and takes a period.
void derive_times(Scan& scan, const SweepTiming& sweep);

/// Point times from the order of the points, which is column by column: `rows` of an instant.
void time_columns(Scan& scan, std::size_t rows, const SweepTiming& sweep);
/// Point times that count back from the stamp, made to count forward.
void count_backward(Scan& scan);

/// The recording with the options' derived or turned times, or, without, one that notes once what
/// is amiss with its scans' times.
[[nodiscard]] std::unique_ptr<Recording> watch_point_times(std::unique_ptr<Recording> recording,
                                                           const OpenOptions& options);

}  // namespace surefoot::io
