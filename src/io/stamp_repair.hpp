// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that cannot be: a scan that claims to be from yesterday, a clock that jumps back, a driver
// that sends one stamp for ever. What the scans before and after tell is taken instead, and said.
#pragma once

#include <memory>

#include "io/recording.hpp"

namespace surefoot::io {

/// The recording with its stamps made to grow. A scan waits for two more before it is given out.
///
/// - One scan far off its neighbours, which fit each other, or so soon after the last one (or so
///   late before the next) that their sweeps would overlap by half: it is put where it belongs.
/// - The first or the last, a thousand intervals from all others while no receipt says that so much
///   time passed: likewise.
/// - From some scan on earlier than before, or far ahead of when its message was recorded, compared
///   to all before: the clock was set. It goes on where it was, as many intervals later as passed
///   between the recordings, one where that is not known.
/// - Equal to the one before: the stamp stands. The usual interval is taken instead; a scan that is
///   the same as the one before, point by point, was sent twice and is left out.
/// - That of any scan before, and so are the points: it was sent again (repeated_scans.hpp), and is
///   left out before anything else is asked.
/// Any other jump forward that stays is a gap, however long: time may have passed.
/// Before, stamps are held against points that have a clock (point_clock.hpp); afterwards those of
/// a whole recording that come and go are steadied (stamp_steadying.hpp).
///
/// With `repair_at_once` none waits. A stamp that does not grow, or is far ahead of when its
/// message was received, compared to all before, counts for nothing, until three go on from each
/// other: then the clock was set. Where stamps do not help, receipts tell how many intervals have
/// passed. Stamps that come and go are steadied by those before alone.
[[nodiscard]] std::unique_ptr<Recording> repair_stamps(std::unique_ptr<Recording> recording,
                                                       const OpenOptions& options);

}  // namespace surefoot::io
