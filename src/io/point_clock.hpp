// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Point times that are absolute, or of the LiDAR's own clock, tell when a scan was measured
// whatever its stamp says. Where stamps stand, jump or are none, they are taken from the points.
#pragma once

#include <memory>

#include "io/recording.hpp"

namespace surefoot::io {

/// The recording with stamps and points' clock made to agree. Usually a stamp keeps its distance
/// from the scan's first point; where it does not, by more than half an interval, what goes on
/// nearer to the usual interval (or to that of receipts) is believed, and the other one follows it.
/// The first scan is compared with the next two, unless `repair_at_once`. Scans without such times
/// are left alone.
[[nodiscard]] std::unique_ptr<Recording> follow_point_clock(std::unique_ptr<Recording> recording,
                                                            const OpenOptions& options);

}  // namespace surefoot::io
