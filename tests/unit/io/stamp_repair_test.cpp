// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that cannot be, mended by what the scans before and after tell.
#include "io/stamp_repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace surefoot::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kFirstScan = 1'700'000'000 * kSecond + 123;

/// Scans out of memory, each of one point that tells its number.
class Stamped : public Recording {
 public:
  explicit Stamped(std::vector<std::int64_t> stamps) : stamps_(std::move(stamps)) {}
  std::optional<ScanItem> next() override {
    if (next_ == stamps_.size()) return std::nullopt;
    ScanItem item;
    item.name = "scan " + std::to_string(next_);
    item.scan.emplace();
    item.scan->points = {{1.0F, 2.0F, static_cast<float>(next_)}};
    item.scan->stamp_ns = stamps_[next_++];
    return item;
  }
  std::optional<std::size_t> size() const override { return stamps_.size(); }
  void skip(std::size_t scans) override { next_ = std::min(next_ + scans, stamps_.size()); }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return "memory"; }

 private:
  std::vector<std::int64_t> stamps_;
  std::size_t next_ = 0;
  std::vector<std::string> notes_;
};

std::vector<std::int64_t> regular(std::size_t count) {
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < count; ++i) {
    stamps.push_back(kFirstScan + static_cast<std::int64_t>(i) * kSecond / 10);
  }
  return stamps;
}

struct Repaired {
  std::vector<std::int64_t> stamps;
  std::vector<std::string> notes;
};

Repaired repaired(std::vector<std::int64_t> stamps) {
  const auto recording = repair_stamps(std::make_unique<Stamped>(std::move(stamps)), {});
  Repaired result;
  while (const auto item = recording->next()) result.stamps.push_back(item->scan->stamp_ns);
  result.notes = recording->notes();
  return result;
}

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
  const auto recording =
      repair_stamps(std::make_unique<Received>(std::move(stamps), std::move(true_stamps)), options);
  Repaired result;
  while (const auto item = recording->next()) result.stamps.push_back(item->scan->stamp_ns);
  result.notes = recording->notes();
  return result;
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

TEST(StampRepair, WhatWasSentTwiceIsLeftOut) {
  class Twice : public Stamped {
   public:
    Twice() : Stamped(regular(10)) {}
    std::optional<ScanItem> next() override {
      if (again_) return std::exchange(again_, std::nullopt);
      std::optional<ScanItem> item = Stamped::next();
      if (item && item->name == "scan 4") again_ = item;
      return item;
    }
    std::optional<ScanItem> again_;
  };
  const auto recording = repair_stamps(std::make_unique<Twice>(), {});
  std::vector<std::int64_t> stamps;
  while (const auto item = recording->next()) stamps.push_back(item->scan->stamp_ns);
  EXPECT_EQ(stamps, regular(10));
  EXPECT_EQ(recording->notes().size(), 1U);
}

// A driver that hangs sends the last scan on and on, under new stamps.
TEST(StampRepair, TheSamePointsUnderNewStampsAreLeftOutWhereScansDiffer) {
  class Hanging : public Stamped {
   public:
    explicit Hanging(float from, float to) : Stamped(regular(10)), from_(from), to_(to) {}
    std::optional<ScanItem> next() override {
      std::optional<ScanItem> item = Stamped::next();
      if (!item) return item;
      float& number = item->scan->points.front().z();
      if (number > from_ && number <= to_) number = from_;
      return item;
    }
    float from_, to_;
  };
  const auto stamps = [](float from, float to) {
    const auto recording = repair_stamps(std::make_unique<Hanging>(from, to), {});
    std::vector<std::int64_t> given;
    while (const auto item = recording->next()) given.push_back(item->scan->stamp_ns);
    return given;
  };
  std::vector<std::int64_t> without = regular(10);
  without.erase(without.begin() + 4, without.begin() + 7);
  EXPECT_EQ(stamps(3.0F, 6.0F), without);
  EXPECT_EQ(stamps(0.0F, 9.0F), regular(10));  // all alike: a recording that was made so
}

TEST(StampRepair, AnythingGrows) {
  constexpr auto kFar = std::numeric_limits<std::int64_t>::max() / 8;
  std::vector<std::int64_t> stamps = {kFar, -kFar, 0, 5, -7, -kFar, 3, kFar, 1, 2, 0};
  for (int turn = 0; turn < 11; ++turn) {
    std::rotate(stamps.begin(), stamps.begin() + 1, stamps.end());
    const Repaired result = repaired(stamps);
    ASSERT_EQ(result.stamps.size(), stamps.size());
    for (std::size_t i = 1; i < result.stamps.size(); ++i) {
      EXPECT_GT(result.stamps[i], result.stamps[i - 1]) << turn << " " << i;
    }
  }
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(repaired({kMost, kLeast, 0, kMost, kLeast, kMost, kMost}).stamps.size(), 7U);
  EXPECT_TRUE(repaired({}).stamps.empty());
}

}  // namespace
}  // namespace surefoot::io
