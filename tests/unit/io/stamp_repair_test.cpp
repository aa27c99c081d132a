// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that cannot be, mended by what the scans before and after tell.
#include "io/stamp_repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "unit/io/stamped_recording.hpp"

namespace surefoot::io {
namespace {

using namespace test;  // NOLINT: the recordings of the test support

Repaired repaired_by_receipts(std::vector<std::int64_t> stamps,
                              std::vector<std::int64_t> true_stamps, const OpenOptions& options);

TEST(StampRepair, LeavesWhatCanBeToTheNanosecond) {
  std::vector<std::int64_t> stamps = regular(30);
  stamps[7] += 12'345'678;                                            // jitter
  for (std::size_t i = 12; i < 30; ++i) stamps[i] += 40 * kSecond;    // a gap
  for (std::size_t i = 20; i < 30; ++i) stamps[i] += 3600 * kSecond;  // and a long one
  const Repaired result = repaired(stamps);
  EXPECT_EQ(result.stamps, stamps);
  ASSERT_EQ(result.notes.size(), 1U);  // of the first gap
  EXPECT_NE(result.notes[0].find("40.100000000 s without a scan before scan 12"), std::string::npos)
      << result.notes[0];
}

/// A capture begins within a revolution, which the next one follows early.
class BegunWithin : public Stamped {
 public:
  using Stamped::Stamped;
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (item && !std::exchange(begun_, true)) item->remark = "partial revolution";
    return item;
  }

 private:
  bool begun_ = false;
};

TEST(StampRepair, ThePartOfARevolutionAtTheStartTellsNoInterval) {
  std::vector<std::int64_t> stamps = regular(20);
  stamps[0] = stamps[1] - kSecond / 100;
  const Repaired result = repaired(std::make_unique<BegunWithin>(stamps), {});
  EXPECT_EQ(result.stamps, stamps);
  EXPECT_TRUE(result.notes.empty()) << result.notes.front();
}

TEST(StampRepair, AnIntervalAloneIsNoGap) {
  std::vector<std::int64_t> stamps = regular(20);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    stamps[i] += static_cast<std::int64_t>(i) * kSecond;  // less than one scan a second
  }
  const Repaired result = repaired(stamps);
  EXPECT_EQ(result.stamps, stamps);
  EXPECT_TRUE(result.notes.empty()) << result.notes.front();
}

TEST(StampRepair, OneWildStampIsPutWhereItBelongs) {
  for (const std::int64_t off : {2 * kSecond, -2 * kSecond, 3600 * kSecond, -3600 * kSecond}) {
    for (const std::size_t at : {std::size_t{0}, std::size_t{1}, std::size_t{9}}) {
      std::vector<std::int64_t> stamps = regular(20);
      stamps[at] += off;
      if (at == 0 && off < 0) continue;  // a gap after the first scan
      const Repaired result = repaired(stamps);
      EXPECT_EQ(result.stamps, regular(20)) << off << " at " << at;
      ASSERT_EQ(result.notes.size(), 1U);
      EXPECT_NE(result.notes[0].find("scan " + std::to_string(at)), std::string::npos);
    }
  }
}

// A hundred seconds beside a single scan, while nothing says that they passed.
TEST(StampRepair, TheFirstAndTheLastAreWildWhereTheyAreFarOff) {
  for (const std::size_t at : {std::size_t{0}, std::size_t{19}}) {
    std::vector<std::int64_t> stamps = regular(20);
    stamps[at] += (at == 0 ? -1 : 1) * 1000 * kSecond;
    const Repaired result = repaired(stamps);
    EXPECT_EQ(result.stamps, regular(20)) << at;
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_NE(result.notes[0].find("scan " + std::to_string(at)), std::string::npos);
    // By receipts it is a gap.
    EXPECT_EQ(repaired_by_receipts(stamps, stamps, {}).stamps, stamps);
    // Two scans of different days are no recording with one wild stamp.
    stamps = {kFirstScan, kFirstScan + 1000 * kSecond};
    EXPECT_EQ(repaired(stamps).stamps, stamps);
  }
}

TEST(StampRepair, AClockThatIsSetBackGoesOn) {
  for (const std::int64_t back : {kSecond / 2, 2 * kSecond, 3600 * kSecond}) {
    std::vector<std::int64_t> stamps = regular(20);
    for (std::size_t i = 8; i < 20; ++i) stamps[i] -= back;
    const Repaired result = repaired(stamps);
    EXPECT_EQ(result.stamps, regular(20)) << back;
    EXPECT_EQ(result.notes.size(), 1U);
  }
}

TEST(StampRepair, StampsThatStandGrowByTheUsualInterval) {
  std::vector<std::int64_t> stamps = regular(20);
  for (std::size_t i = 8; i < 20; ++i) stamps[i] = stamps[7];
  EXPECT_EQ(repaired(stamps).stamps, regular(20));
  // From the first on: nothing tells the interval, 10 a second is assumed.
  EXPECT_EQ(repaired(std::vector<std::int64_t>(20, kFirstScan)).stamps, regular(20));
}

/// When messages were received, too, 5 ms after the stamps that they should have.
class Received : public Stamped {
 public:
  Received(std::vector<std::int64_t> stamps, std::vector<std::int64_t> true_stamps)
      : Stamped(std::move(stamps)), true_stamps_(std::move(true_stamps)) {}
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (item) item->logged_ns = true_stamps_[next_++] + kSecond / 200;
    return item;
  }

 private:
  std::vector<std::int64_t> true_stamps_;
  std::size_t next_ = 0;
};

Repaired repaired_by_receipts(std::vector<std::int64_t> stamps,
                              std::vector<std::int64_t> true_stamps, const OpenOptions& options) {
  return repaired(std::make_unique<Received>(std::move(stamps), std::move(true_stamps)), options);
}

/// Live: no look ahead.
Repaired repaired_at_once(std::vector<std::int64_t> stamps, std::vector<std::int64_t> true_stamps) {
  OpenOptions options;
  options.repair_at_once = true;
  options.rate_hz = 10.0;
  return repaired_by_receipts(std::move(stamps), std::move(true_stamps), options);
}

TEST(StampRepair, AClockThatIsSetAheadIsToldFromAGapByReceipts) {
  std::vector<std::int64_t> ahead = regular(20);
  for (std::size_t i = 8; i < 20; ++i) ahead[i] += 3600 * kSecond;
  const Repaired set = repaired_by_receipts(ahead, regular(20), {});
  EXPECT_EQ(set.stamps, regular(20));
  ASSERT_EQ(set.notes.size(), 1U);
  EXPECT_NE(set.notes[0].find("jumps ahead"), std::string::npos) << set.notes[0];
  EXPECT_NE(set.notes[0].find("scan 8"), std::string::npos) << set.notes[0];

  const Repaired gap = repaired_by_receipts(ahead, ahead, {});
  EXPECT_EQ(gap.stamps, ahead);
  // The last one before the gap was held up until the first after it came.
  std::vector<std::int64_t> held_up = ahead;
  held_up[7] = ahead[8];
  EXPECT_EQ(repaired_by_receipts(ahead, held_up, {}).stamps, ahead);

  // As many intervals later as passed: three scans were lost where the clock was set.
  std::vector<std::int64_t> true_stamps = regular(20);
  for (std::size_t i = 8; i < 20; ++i) true_stamps[i] += 3 * kSecond / 10;
  EXPECT_EQ(repaired_by_receipts(ahead, true_stamps, {}).stamps, true_stamps);
}

TEST(StampRepairAtOnce, LeavesWhatCanBeToTheNanosecond) {
  std::vector<std::int64_t> stamps = regular(30);
  stamps[7] += 12'345'678;                                            // jitter
  for (std::size_t i = 12; i < 30; ++i) stamps[i] += 40 * kSecond;    // a gap
  for (std::size_t i = 20; i < 30; ++i) stamps[i] += 3600 * kSecond;  // and a long one
  std::vector<std::int64_t> late = stamps;
  for (std::size_t i = 15; i < 18; ++i) late[i] = stamps[18];  // some were held up
  const Repaired result = repaired_at_once(stamps, late);
  EXPECT_EQ(result.stamps, stamps);
  ASSERT_EQ(result.notes.size(), 1U);
  EXPECT_NE(result.notes[0].find("a gap"), std::string::npos) << result.notes[0];
}

TEST(StampRepairAtOnce, AStampThatCannotBeCountsForNothing) {
  for (const std::size_t at : {std::size_t{3}, std::size_t{9}}) {
    for (const std::int64_t wild : {kFirstScan, std::int64_t{0}, kFirstScan + 3600 * kSecond}) {
      std::vector<std::int64_t> stamps = regular(20);
      stamps[at] = wild;
      const Repaired result = repaired_at_once(stamps, regular(20));
      EXPECT_EQ(result.stamps, regular(20)) << wild << " at " << at;
      EXPECT_EQ(result.notes.size(), 1U);
    }
  }
}

TEST(StampRepairAtOnce, AClockThatIsSetGoesOn) {
  for (const std::int64_t by : {-kSecond / 2, -3600 * kSecond, 3600 * kSecond}) {
    std::vector<std::int64_t> stamps = regular(20);
    for (std::size_t i = 8; i < 20; ++i) stamps[i] += by;
    EXPECT_EQ(repaired_at_once(stamps, regular(20)).stamps, regular(20)) << by;
  }
}

TEST(StampRepairAtOnce, WhereStampsStandReceiptsTellWhatWasLost) {
  std::vector<std::int64_t> true_stamps = regular(20);
  true_stamps.erase(true_stamps.begin() + 6, true_stamps.begin() + 9);
  EXPECT_EQ(repaired_at_once(std::vector<std::int64_t>(17, kFirstScan), true_stamps).stamps,
            true_stamps);
}

TEST(StampRepair, AStampRightAfterTheLastOneIsPutWhereItBelongs) {
  for (const std::int64_t after : {10'000, 1'000'000, 30'000'000}) {
    std::vector<std::int64_t> stamps = regular(20);
    stamps[9] = stamps[8] + after;
    const Repaired result = repaired_sweeps(stamps);
    EXPECT_EQ(result.stamps, regular(20)) << after;
    EXPECT_EQ(result.notes.size(), 1U);
    EXPECT_EQ(repaired(stamps).stamps, regular(20)) << "without point times";
    OpenOptions live;
    live.repair_at_once = true;
    EXPECT_EQ(repaired_sweeps(stamps, 99'900'000, live).stamps, regular(20)) << after;
  }
}

// Those after it are right, and no clock was set.
TEST(StampRepair, AStampThatComesLateIsPutWhereItBelongs) {
  for (const std::int64_t by : {85'000'000, 110'000'000, 250'000'000}) {
    std::vector<std::int64_t> stamps = regular(60);
    for (std::size_t i = 6; i < stamps.size(); i += 9) stamps[i] += by;
    EXPECT_EQ(repaired_sweeps(stamps).stamps, regular(60)) << by;
    EXPECT_EQ(repaired(stamps).stamps, regular(60)) << by;
  }
}

TEST(StampRepair, SweepsThatOverlapAllAlongAreLeftAsTheyAre) {
  std::vector<std::int64_t> two_lidars = regular(60), windows = regular(60);
  for (std::size_t i = 0; i < 60; ++i) {
    two_lidars[i] = kFirstScan + static_cast<std::int64_t>(i / 2) * kSecond / 10 +
                    static_cast<std::int64_t>(i % 2) * 3'000'000;
    windows[i] = kFirstScan + static_cast<std::int64_t>(i) * kSecond / 50;
  }
  EXPECT_EQ(repaired_sweeps(two_lidars).stamps, two_lidars);
  EXPECT_EQ(repaired_sweeps(windows).stamps, windows);
}

// Messages are late, never early: the clock is the one before, not that of the late one.
TEST(StampRepair, LiveALateScanDoesNotSetTheClock) {
  OpenOptions live;
  live.repair_at_once = true;
  for (const std::int64_t late : {80'000'000, 110'000'000, 150'000'000, 190'000'000}) {
    std::vector<std::int64_t> given = regular(60);
    given[40] += late;
    const std::vector<std::int64_t> stamps = repaired_sweeps(given, 99'900'000, live).stamps;
    EXPECT_EQ(std::vector(stamps.begin() + 45, stamps.end()),
              std::vector(given.begin() + 45, given.end()))
        << late;
    for (std::size_t i = 1; i < stamps.size(); ++i) {
      EXPECT_GT(stamps[i] - stamps[i - 1], 0) << late << ' ' << i;
    }
  }
}

TEST(StampRepair, AnythingGrows) {
  const auto expect_growing = [](const std::vector<std::int64_t>& stamps) {
    const Repaired result = repaired(stamps);
    EXPECT_EQ(result.stamps.size(), stamps.size());
    for (std::size_t i = 1; i < result.stamps.size(); ++i) {
      EXPECT_GT(result.stamps[i], result.stamps[i - 1]) << stamps.front() << " " << i;
    }
    return result.stamps.back();
  };
  constexpr auto kFar = std::numeric_limits<std::int64_t>::max() / 8;
  std::vector<std::int64_t> stamps = {kFar, -kFar, 0, 5, -7, -kFar, 3, kFar, 1, 2, 0};
  for (int turn = 0; turn < 11; ++turn) {
    std::rotate(stamps.begin(), stamps.begin() + 1, stamps.end());
    expect_growing(stamps);
  }
  // A clock that was set back by centuries and then ahead: it goes on where it was all the same.
  const std::int64_t last = expect_growing({kFirstScan, -3 * kFar, kFirstScan, -2 * kFar});
  EXPECT_NEAR(static_cast<double>(last - kFirstScan), 0.3 * kSecond, 1e6);
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(repaired({kMost, kLeast, 0, kMost, kLeast, kMost, kMost}).stamps.size(), 7U);
  EXPECT_TRUE(repaired({}).stamps.empty());
}

// Every fifth scan of a regular recording is no gap, and what is not given out tells the interval.
TEST(StampRepair, ScansThatArePassedOverAreNoGaps) {
  std::vector<std::int64_t> stamps = regular(100);
  stamps[70] += 20 * kSecond;
  const auto recording = repair_stamps(std::make_unique<Stamped>(stamps), {});
  recording->skip(5);
  std::vector<std::int64_t> read;
  while (const auto item = recording->next()) {
    read.push_back(item->scan->stamp_ns);
    recording->skip(4);
  }
  ASSERT_EQ(read.size(), 19U);
  for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], regular(100)[5 + 5 * i]) << i;
  ASSERT_EQ(recording->notes().size(), 1U);
  EXPECT_NE(recording->notes()[0].find("fits neither side"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::io
