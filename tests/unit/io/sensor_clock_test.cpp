// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/sensor_clock.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::io {
namespace {

constexpr auto kPastHour = sensors::TimeBase::hour;
constexpr std::int64_t kHour = 3'600'000'000'000;
constexpr std::int64_t kCapture = 403'712 * kHour + 1'082'708'714'000;

TEST(SensorClock, JoinsTheHourOfTheCapture) {
  SensorClock clock;
  EXPECT_EQ(clock.read(1'082'340'595'000LL, kPastHour, kCapture)->stamp_ns,
            403'712 * kHour + 1'082'340'595'000);
  EXPECT_EQ(clock.read(1'082'341'923'000LL, kPastHour, kCapture + 5)->since_last_ns, 1'328'000);
  EXPECT_FALSE(clock.read(1'082'341'923'000LL, kPastHour, kCapture + 9));  // repeated
  EXPECT_FALSE(clock.read(1'082'341'000'000LL, kPastHour, kCapture + 9));  // out of order
}

TEST(SensorClock, UnwrapsOverTheHour) {
  SensorClock clock;
  const std::int64_t before =
      clock.read(3'599'999'500'000LL, kPastHour, 10 * kHour + 100)->stamp_ns;
  EXPECT_EQ(before, 10 * kHour - 500'000);  // the capture's clock is already in the next hour
  EXPECT_EQ(clock.read(827'000LL, kPastHour, 10 * kHour + 1'327'000)->stamp_ns - before, 1'327'000);
}

TEST(SensorClock, WithoutGpsTheCaptureGivesTheStart) {
  SensorClock clock;
  EXPECT_EQ(clock.read(17'000LL, kPastHour, kCapture)->stamp_ns, kCapture);
  EXPECT_EQ(clock.read(1344'000LL, kPastHour, kCapture + 999'999)->stamp_ns, kCapture + 1'327'000);
  EXPECT_NE(clock.note().find("differ by"), std::string::npos);
  const auto jump = clock.read(1'082'000'000'000LL, kPastHour, kCapture + 2'000'000);  // GPS found
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->stamp_ns, kCapture + 1'327'000 + 1'000'001);
}

TEST(SensorClock, SinceTheEpochIsTakenAsItIs) {
  SensorClock clock;
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  const std::int64_t ptp = kCapture + 37'000'000'000;  // TAI
  EXPECT_EQ(clock.read(ptp, kAbsolute, kCapture)->stamp_ns, ptp);
  EXPECT_EQ(clock.read(ptp + 100, kAbsolute, kCapture)->stamp_ns, ptp + 100);
  EXPECT_NE(clock.source().find("PTP"), std::string::npos);
  SensorClock since_start;
  EXPECT_EQ(since_start.read(5'000, kAbsolute, kCapture)->stamp_ns, kCapture);
  EXPECT_EQ(since_start.read(5'700, kAbsolute, kCapture + 3)->stamp_ns, kCapture + 700);
  EXPECT_FALSE(since_start.read(-1, kAbsolute, kCapture));
  EXPECT_FALSE(since_start.read(std::numeric_limits<std::int64_t>::max(), kAbsolute, kCapture));
}

// Packets that stay behind the clock's last reading are late; if all do, the clock was set back.
TEST(SensorClock, AClockThatIsSetBackIsBridged) {
  SensorClock clock;
  ASSERT_TRUE(clock.read(1'000'000'000, kPastHour, kCapture));
  EXPECT_FALSE(clock.read(500'000'000, kPastHour, kCapture + 90'000'000));
  const auto jump = clock.read(520'000'000, kPastHour, kCapture + 110'000'000);
  ASSERT_TRUE(jump);
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->since_last_ns, 110'000'000);
  EXPECT_FALSE(clock.read(521'000'000, kPastHour, kCapture + 111'000'000)->jumped);
}

// NTP sets the receiver's clock while the sensor's goes on.
TEST(SensorClock, AReceiversClockThatIsSetMovesNoStamp) {
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  for (const std::int64_t set : {-kHour, -kHour / 1200, kHour / 1200}) {
    for (const auto base : {kPastHour, kAbsolute}) {
      SensorClock clock;
      const std::int64_t begin = base == kAbsolute ? kCapture : kCapture % kHour;
      ASSERT_TRUE(clock.read(begin, base, kCapture));
      std::int64_t arrival = kCapture + set;
      for (int packet = 1; packet <= 3; ++packet) {
        const auto next = clock.read(begin + packet * 1'327'000, base, arrival += 1'327'000);
        ASSERT_TRUE(next) << set;
        EXPECT_FALSE(next->jumped);
        EXPECT_EQ(next->stamp_ns, kCapture + packet * 1'327'000);
      }
    }
  }
}

// A sensor that takes its time from the receiver is set back with it.
TEST(SensorClock, BothClocksSetBackLoseNoPacket) {
  SensorClock clock;
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  ASSERT_TRUE(clock.read(kCapture, kAbsolute, kCapture));
  ASSERT_TRUE(clock.read(kCapture + 1'327'000, kAbsolute, kCapture + 1'327'000));
  const std::int64_t back = kCapture - kHour;
  const auto jump = clock.read(back, kAbsolute, back);
  ASSERT_TRUE(jump);
  EXPECT_TRUE(jump->jumped);
  EXPECT_EQ(jump->since_last_ns, 1'327'000);
  EXPECT_FALSE(clock.read(back + 1'327'000, kAbsolute, back + 1'327'000)->jumped);
}

TEST(SensorClock, TheHourIsTheCapturesWhereTheyDifferByTwoSecondsAtMost) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  for (const std::int64_t ahead : {2 * kSecond, -2 * kSecond}) {
    SensorClock clock;
    EXPECT_EQ(clock.read(100 * kSecond + ahead, kPastHour, 9 * kHour + 100 * kSecond)->stamp_ns,
              9 * kHour + 100 * kSecond + ahead);
    SensorClock other;
    const std::int64_t more = ahead + (ahead > 0 ? 1 : -1);
    EXPECT_EQ(other.read(100 * kSecond + more, kPastHour, 9 * kHour + 100 * kSecond)->stamp_ns,
              9 * kHour + 100 * kSecond);
  }
}

// By however little: all that follows would be late.
TEST(SensorClock, AClockThatStaysBehindForATenthOfASecondWasSetBack) {
  SensorClock clock;
  ASSERT_TRUE(clock.read(1'000'000'000, kPastHour, kCapture));
  EXPECT_FALSE(clock.read(950'000'000, kPastHour, kCapture + 100'000'000));
  const auto jump = clock.read(950'000'000, kPastHour, kCapture + 100'000'001);
  ASSERT_TRUE(jump);
  EXPECT_TRUE(jump->jumped);
}

TEST(SensorClock, APacketBeforeTheLastHasItsStampUpToATenthOfASecond) {
  SensorClock clock;
  EXPECT_FALSE(clock.stamp_before_last(kHour - 1'000, kPastHour)) << "there is no last one";
  const std::int64_t last = clock.read(827'000, kPastHour, 10 * kHour + 827'000)->stamp_ns;
  EXPECT_EQ(clock.stamp_before_last(kHour - 500'000, kPastHour), last - 1'327'000);
  EXPECT_FALSE(clock.read(kHour - 500'000, kPastHour, 10 * kHour + 828'000)) << "it is late";
  EXPECT_EQ(clock.stamp_before_last(kHour + 827'000 - 100'000'000, kPastHour), last - 100'000'000);
  EXPECT_FALSE(clock.stamp_before_last(kHour + 827'000 - 100'000'001, kPastHour));
  EXPECT_FALSE(clock.stamp_before_last(827'000, kPastHour));
  EXPECT_FALSE(clock.stamp_before_last(-1, kPastHour));
}

TEST(SensorClock, TimesAndStampsHaveALimit) {
  constexpr auto kAbsolute = sensors::TimeBase::absolute;
  constexpr std::int64_t kGreatest = 4'500'000'000'000'000'000;
  EXPECT_TRUE(SensorClock().read(kGreatest, kAbsolute, kCapture));
  EXPECT_FALSE(SensorClock().read(kGreatest + 1, kAbsolute, kCapture));
  for (const std::int64_t arrival : {-kGreatest, kGreatest}) {
    EXPECT_TRUE(SensorClock().read(17'000, kPastHour, arrival));
    EXPECT_FALSE(SensorClock().read(17'000, kPastHour, arrival + arrival / kGreatest));
  }
  SensorClock clock;
  ASSERT_TRUE(clock.read(kGreatest - 1'000'000'000, kAbsolute, kCapture));
  EXPECT_FALSE(clock.read(kGreatest - 2'000'000'000, kAbsolute, kCapture + 1'000'000'001));
  EXPECT_TRUE(clock.read(kGreatest - 2'000'000'000, kAbsolute, kCapture + 1'000'000'000)->jumped);
}

}  // namespace
}  // namespace surefoot::io
