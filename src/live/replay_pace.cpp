// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/replay_pace.hpp"

#include <algorithm>
#include <thread>

namespace surefoot::live {

/// Clocks of recordings jump; a pause is waited for, but a minute at most.
bool ReplayPace::is_due(std::int64_t stamp_ns) {
  using Clock = std::chrono::steady_clock;
  constexpr Clock::duration kLongestSleep = std::chrono::milliseconds(100);
  constexpr std::int64_t kLongestPause = 60'000'000'000;
  if (is_at_once()) return true;
  const Clock::time_point now = Clock::now();
  const std::int64_t since_ns =
      last_ns_ ? std::clamp<std::int64_t>(stamp_ns - *last_ns_, 0, kLongestPause) : 0;
  if (!last_ns_) due_ = now;
  due_ +=
      std::chrono::nanoseconds(static_cast<std::int64_t>(static_cast<double>(since_ns) / speed_));
  last_ns_ = stamp_ns;
  if (due_ <= now) return true;
  const Clock::duration left = due_ - now;
  std::this_thread::sleep_for(std::min(left, kLongestSleep));
  return left <= kLongestSleep;
}

}  // namespace surefoot::live
