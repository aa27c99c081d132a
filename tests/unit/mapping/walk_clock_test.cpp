// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/walk_clock.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::mapping {
namespace {

constexpr std::int64_t kOneSecond = 1'000'000'000;

TEST(WalkClock, IsTheSensorsAsLongAsThatGoesOn) {
  WalkClock clock;
  EXPECT_EQ(clock.at(7), 7);
  for (const std::int64_t stamp : {5 * kOneSecond, 6 * kOneSecond, 60 * kOneSecond}) {
    EXPECT_EQ(clock.next(stamp), stamp);
  }
  EXPECT_EQ(clock.begin_ns(), 5 * kOneSecond);
  EXPECT_EQ(clock.at(30 * kOneSecond), 30 * kOneSecond);
  EXPECT_EQ(clock.at(kOneSecond), kOneSecond);
}

TEST(WalkClock, GoesOnWhereTheSensorsWasSetBack) {
  WalkClock clock;
  for (std::int64_t stamp = 100; stamp <= 110; ++stamp) (void)clock.next(stamp * kOneSecond);
  EXPECT_EQ(clock.next(105 * kOneSecond), 111 * kOneSecond);
  EXPECT_EQ(clock.next(107 * kOneSecond), 113 * kOneSecond);
  EXPECT_EQ(clock.next(3 * kOneSecond), 114 * kOneSecond);
  EXPECT_EQ(clock.next(4 * kOneSecond), 115 * kOneSecond);
  EXPECT_EQ(clock.begin_ns(), 100 * kOneSecond);
  EXPECT_EQ(clock.at(4 * kOneSecond), 115 * kOneSecond);
  EXPECT_EQ(clock.at(108 * kOneSecond), 108 * kOneSecond) << "before it was set back";
  EXPECT_EQ(clock.at(106 * kOneSecond), 112 * kOneSecond) << "between the two times";
}

TEST(WalkClock, OfAStampThatWasNeverShownTheNearestOnesCount) {
  WalkClock clock;
  for (std::int64_t stamp = 100; stamp <= 110; ++stamp) (void)clock.next(stamp * kOneSecond);
  for (std::int64_t stamp = 3; stamp <= 4; ++stamp) (void)clock.next(stamp * kOneSecond);
  EXPECT_EQ(clock.at(112 * kOneSecond), 112 * kOneSecond);
  EXPECT_EQ(clock.at(98 * kOneSecond), 98 * kOneSecond);
  EXPECT_EQ(clock.at(5 * kOneSecond), 113 * kOneSecond);
  EXPECT_EQ(clock.at(2 * kOneSecond), 110 * kOneSecond);
}

// What stood at a stamp when it was last shown.
TEST(WalkClock, OfAStampThatWasShownTwiceTheLastCounts) {
  WalkClock clock;
  for (std::int64_t stamp = 100; stamp <= 110; ++stamp) (void)clock.next(stamp * kOneSecond);
  for (std::int64_t stamp = 105; stamp <= 120; ++stamp) (void)clock.next(stamp * kOneSecond);
  EXPECT_EQ(clock.at(104 * kOneSecond), 104 * kOneSecond);
  EXPECT_EQ(clock.at(108 * kOneSecond), 114 * kOneSecond);
  EXPECT_EQ(clock.at(120 * kOneSecond), 126 * kOneSecond);
}

// As who asks for the walk's begin or end without knowing when it was.
TEST(WalkClock, AnyStampMayBeAskedFor) {
  using Limits = std::numeric_limits<std::int64_t>;
  WalkClock clock;
  constexpr std::int64_t kToday = 1'800'000'000 * kOneSecond;
  const std::int64_t begin = clock.next(kToday);
  const std::int64_t end = clock.next(kToday - kOneSecond);
  EXPECT_LT(clock.at(Limits::min()), begin);
  EXPECT_GT(clock.at(Limits::max()), end);
}

}  // namespace
}  // namespace surefoot::mapping
