// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/scan_clock.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>

namespace surefoot::test {
namespace {

constexpr std::int64_t kPeriod = 100'000'000;  // [ns] ten scans a second
constexpr std::int64_t kHour = 36'000 * kPeriod;
constexpr int kFollowedAfter = 10;  // refused in a row

/// As the odometry asks it, of scans that take no time.
class ScanClockTest : public testing::Test {
 protected:
  /// By how much what goes on is ahead of this scan's stamp; nothing: it was refused.
  std::optional<std::int64_t> offer(std::int64_t mid_ns) {
    if (!clock_.objection(mid_ns, mid_ns).empty()) {
      clock_.refuse(mid_ns);
      return std::nullopt;
    }
    const std::int64_t ahead_ns = clock_.follow(mid_ns);
    clock_.used(mid_ns + ahead_ns);
    return ahead_ns;
  }

  /// How many of these were refused before one was followed.
  int refused_from(std::int64_t first_ns, std::int64_t step_ns, int most) {
    for (int i = 0; i < most; ++i) {
      if (offer(first_ns + i * step_ns)) return i;
    }
    return most;
  }

  ScanClock clock_;
};

TEST_F(ScanClockTest, WhatGoesOnIsFollowedAsItIs) {
  for (const std::int64_t stamp : {-kHour, -kPeriod, std::int64_t{0}, kPeriod, kHour}) {
    EXPECT_EQ(offer(stamp), 0) << stamp;
  }
}

TEST_F(ScanClockTest, OneThatIsLateOrComesTwiceIsRefused) {
  EXPECT_EQ(offer(5 * kPeriod), 0);
  EXPECT_FALSE(offer(5 * kPeriod));
  EXPECT_EQ(offer(6 * kPeriod), 0);
  EXPECT_FALSE(offer(3 * kPeriod));
  EXPECT_EQ(offer(7 * kPeriod), 0) << "one was late, no clock was set back";
}

TEST_F(ScanClockTest, ObjectionsNameBothStamps) {
  EXPECT_EQ(offer(2'000), 0);
  EXPECT_EQ(clock_.objection(1'500, 1'500),
            "scan's mid-scan stamp 1500 ns is not after the last scan's 2000 ns");
}

// Two scans refused, then stamps beyond the last one's: they were set back by as much as the scans
// refused, and this one, took.
TEST_F(ScanClockTest, ScansRefusedTookTimeToo) {
  EXPECT_EQ(offer(10 * kPeriod), 0);
  EXPECT_FALSE(offer(9 * kPeriod));
  EXPECT_FALSE(offer(10 * kPeriod));
  EXPECT_EQ(offer(11 * kPeriod), 2 * kPeriod);
  EXPECT_EQ(offer(12 * kPeriod), 2 * kPeriod);
}

TEST_F(ScanClockTest, OneFarAheadIsFollowedOnceTheOthersStay) {
  EXPECT_EQ(offer(0), 0);
  EXPECT_EQ(offer(kHour), 0) << "nothing tells yet that this is the wrong one";
  EXPECT_EQ(refused_from(kPeriod, kPeriod, 50), kFollowedAfter);
  const auto ahead_ns = offer((kFollowedAfter + 2) * kPeriod);
  ASSERT_TRUE(ahead_ns);
  EXPECT_GT(*ahead_ns + (kFollowedAfter + 2) * kPeriod, kHour) << "what goes on goes on";
}

// A first stamp of a clock that was not set yet, and wrong by centuries.
TEST_F(ScanClockTest, AnAbsurdFirstStampDoesNotRefuseAllOthers) {
  EXPECT_EQ(offer(9'000'000'000'000'000'000), 0);
  EXPECT_EQ(refused_from(1'700'000'000'000'000'000, kPeriod, 100), kFollowedAfter);
}

TEST_F(ScanClockTest, OnesThatDoNotRiseAreNeverFollowed) {
  EXPECT_EQ(offer(kHour), 0);
  EXPECT_EQ(refused_from(20 * kPeriod, 0, 30), 30) << "the same one again and again";
  EXPECT_EQ(refused_from(50 * kPeriod, -kPeriod, 30), 30) << "a recording played backwards";
}

// Ten that rise, then one before them: it is no sign that the clock goes on from them.
TEST_F(ScanClockTest, OneBeforeThoseRefusedIsNotFollowed) {
  EXPECT_EQ(offer(kHour), 0);
  EXPECT_EQ(refused_from(kPeriod, kPeriod, kFollowedAfter), kFollowedAfter);
  EXPECT_FALSE(offer(kPeriod / 2));
  EXPECT_FALSE(offer(kPeriod)) << "the count begins anew";
}

TEST_F(ScanClockTest, NineThatRiseAreNotEnough) {
  EXPECT_EQ(offer(kHour), 0);
  EXPECT_EQ(refused_from(kPeriod, kPeriod, kFollowedAfter - 1), kFollowedAfter - 1);
  EXPECT_FALSE(offer(0));
  EXPECT_EQ(refused_from(kPeriod, kPeriod, kFollowedAfter - 1), kFollowedAfter - 1);
}

TEST_F(ScanClockTest, StampsFromTheEndsOfTimeDoNotOverflow) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kFirst = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ(offer(0), 0);
  EXPECT_NE(clock_.objection(kLast / 2 + kLast / 3, kLast / 2 + kLast / 3).find("146 years"),
            std::string::npos);
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(offer(kLast - 30 + i));
    EXPECT_FALSE(offer(kFirst + i));
  }
  EXPECT_EQ(offer(kPeriod), 0);
}

// What would go on from there would go on beyond them.
TEST_F(ScanClockTest, AFirstStampAtTheEndOfTimeIsRefused) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  EXPECT_NE(clock_.objection(kLast, kLast).find("64 bits"), std::string::npos);
  EXPECT_FALSE(offer(kLast));
  EXPECT_FALSE(offer(kLast - kHour));
  EXPECT_EQ(offer(1'700'000'000'000'000'000), 0);
}

// A scan's end is told by the time that goes on, too.
TEST_F(ScanClockTest, AnEndBeyondTheLastInstantIsRefused) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(offer(kHour), 0);
  EXPECT_EQ(refused_from(kPeriod, kPeriod, 50), kFollowedAfter);
  EXPECT_FALSE(clock_.objection(20 * kPeriod, kLast).empty());
}

}  // namespace
}  // namespace surefoot::test
