// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that come and go: a driver that takes the time at which a scan arrived, on a machine that
// has other things to do. A LiDAR turns steadily, as its point times tell.
#pragma once

#include <memory>

#include "io/recording.hpp"

namespace surefoot::io {

/// The recording with its stamps steadied, where the first scans leave no doubt: their sweeps last
/// equally long and follow each other closely on average, but by their stamps many begin before the
/// last one has ended, which cannot be. Sweep follows sweep then as their point times tell, and a
/// line through the last stamps and the next, that few outliers do not move, tells when. A scan
/// that is missing stays missing. Other recordings are given out as they are.
[[nodiscard]] std::unique_ptr<Recording> steady_stamps(std::unique_ptr<Recording> recording);

/// The same without a look at the next scans, for live runs: once the last thirty leave no doubt,
/// by a line through those before. That a scan is missing the third one behind it tells, as the
/// others may be late; sweeps that were counted wrongly are made up for by a tenth at a time.
[[nodiscard]] std::unique_ptr<Recording> steady_stamps_at_once(
    std::unique_ptr<Recording> recording);

}  // namespace surefoot::io
