// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/scan_clock.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace surefoot {

namespace {

// One scan refused for its stamp came late, or twice: the next one's stamp tells all. After so many
// the clock was set back; and after so many that it is not going to catch up soon, that is taken.
constexpr int kClockWasSet = 2, kClockStays = 10, kMostRefused = 1'000'000;

// [ns] between two scans; stamps that are farther apart tell no period.
constexpr std::int64_t kMostPeriod = 10'000'000'000;

// [ns] By so much time at most scans that were refused are taken to have lasted.
constexpr std::int64_t kMostTaken = (kMostRefused + 1) * kMostPeriod;

// [ns] Nothing that goes on from here leaves the range of 64 bits: it is the year 2261.
constexpr std::int64_t kLatest = std::numeric_limits<std::int64_t>::max() - 2 * kMostTaken;

// [ns] half of what two stamps may be apart: 146 years.
constexpr std::int64_t kLongest = std::int64_t{1} << 61;

/// Of any two stamps.
bool are_far_apart(std::int64_t a_ns, std::int64_t b_ns) {
  return std::abs(a_ns / 2 - b_ns / 2) > kLongest;
}

}  // namespace

std::string ScanClock::objection(std::int64_t mid_ns, std::int64_t end_ns) const {
  std::int64_t told_end_ns = 0;
  if (__builtin_add_overflow(end_ns, ahead_ns_, &told_end_ns) || told_end_ns > kLatest) {
    return "scan's mid-scan stamp " + std::to_string(mid_ns) +
           " ns is too near the end of what 64 bits hold";
  }
  if (!last_mid_ns_) return {};
  const std::int64_t last = *last_mid_ns_ - ahead_ns_;
  if (are_far_apart(std::max(mid_ns, last), last)) {
    return "scan's mid-scan stamp " + std::to_string(mid_ns) +
           " ns is more than 146 years after the last scan's " + std::to_string(last) + " ns";
  }
  if (mid_ns > last || stays(mid_ns)) return {};
  return "scan's mid-scan stamp " + std::to_string(mid_ns) + " ns is not after the last scan's " +
         std::to_string(last) + " ns";
}

/// Whether a scan goes on from so many refused before it that nobody waits for the old time.
bool ScanClock::stays(std::int64_t mid_ns) const {
  std::int64_t back_ns = 0;
  return refused_ >= kClockStays && mid_ns > refused_mid_ns_ &&
         !__builtin_sub_overflow(*last_mid_ns_, mid_ns, &back_ns) &&
         back_ns <= std::numeric_limits<std::int64_t>::max() - kMostTaken;
}

void ScanClock::refuse(std::int64_t mid_ns) {
  const bool rises =
      refused_ > 0 && mid_ns > refused_mid_ns_ && !are_far_apart(mid_ns, refused_mid_ns_);
  refused_ = rises ? std::min(refused_ + 1, kMostRefused) : 1;
  refused_mid_ns_ = mid_ns;
}

/// Scans refused for their stamps took time, too, which the stamps of those about them do not tell
/// where the clock was set back.
std::int64_t ScanClock::follow(std::int64_t mid_ns) {
  if (last_mid_ns_ && refused_ >= kClockWasSet && !are_far_apart(mid_ns, refused_mid_ns_)) {
    const std::int64_t told = mid_ns + ahead_ns_ - *last_mid_ns_;
    const std::int64_t period = std::clamp(mid_ns - refused_mid_ns_, std::int64_t{0}, kMostPeriod);
    const std::int64_t took = (refused_ + 1) * period;
    ahead_ns_ += std::max(took - told, std::int64_t{0});
  }
  refused_ = 0;
  return ahead_ns_;
}

}  // namespace surefoot
