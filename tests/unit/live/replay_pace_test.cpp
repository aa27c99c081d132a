// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/replay_pace.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <initializer_list>

namespace surefoot::live {
namespace {

constexpr std::int64_t kMs = 1'000'000, kHour = 3'600'000 * kMs;

/// How long stamps are waited for, the first not at all [s].
double waited_for(double speed, std::initializer_list<std::int64_t> stamps_ns) {
  ReplayPace pace(speed);
  const auto began = std::chrono::steady_clock::now();
  for (const std::int64_t stamp_ns : stamps_ns) {
    while (!pace.is_due(stamp_ns)) continue;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

TEST(ReplayPace, IsSoManyTimesTheRecordingsOwn) {
  const double ten_times = waited_for(10.0, {kHour, kHour + 1000 * kMs, kHour + 2000 * kMs});
  EXPECT_GE(ten_times, 0.199);
  EXPECT_LT(ten_times, 5.0);
  EXPECT_LT(waited_for(0.0, {0, kHour, 2 * kHour}), 1.0) << "at once";
}

TEST(ReplayPace, AClockThatIsSetBackIsFollowedFromThere) {
  EXPECT_GE(waited_for(1.0, {kHour, 0, 100 * kMs}), 0.099);
}

// At 1,200 times: for 50 ms instead of 3 s.
TEST(ReplayPace, APauseIsWaitedForForAMinuteAtMost) {
  const double pause = waited_for(1200.0, {0, kHour});
  EXPECT_GE(pause, 0.049);
  EXPECT_LT(pause, 1.5);
}

}  // namespace
}  // namespace surefoot::live
