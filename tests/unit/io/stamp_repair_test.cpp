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

Repaired repaired(std::unique_ptr<Recording> given, const OpenOptions& options) {
  const auto recording = repair_stamps(std::move(given), options);
  Repaired result;
  while (const auto item = recording->next()) result.stamps.push_back(item->scan->stamp_ns);
  result.notes = recording->notes();
  return result;
}

Repaired repaired(std::vector<std::int64_t> stamps) {
  return repaired(std::make_unique<Stamped>(std::move(stamps)), {});
}

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

/// Scans whose points have times, from the stamp on.
class Swept : public Stamped {
 public:
  Swept(std::vector<std::int64_t> stamps, std::int32_t lasts_ns)
      : Stamped(std::move(stamps)), lasts_ns_(lasts_ns) {}
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (!item) return item;
    item->scan->points.push_back(item->scan->points.front());
    item->scan->times_ns = {0, lasts_ns_};
    return item;
  }

 private:
  std::int32_t lasts_ns_;
};

Repaired repaired_sweeps(std::vector<std::int64_t> stamps, std::int32_t lasts_ns = 99'900'000,
                         const OpenOptions& options = {}) {
  return repaired(std::make_unique<Swept>(std::move(stamps), lasts_ns), options);
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

/// How far off stamps are at most, and by how much more from scan to scan, but for what is common.
struct Off {
  double most_ms = 0.0, step_ms = 0.0;
};
Off off_by(const std::vector<std::int64_t>& stamps, const std::vector<std::int64_t>& right) {
  std::vector<double> off;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    off.push_back(1e-6 * static_cast<double>(stamps[i] - right[i]));
  }
  std::vector<double> sorted = off;
  std::sort(sorted.begin(), sorted.end());
  Off result;
  for (std::size_t i = 0; i < off.size(); ++i) {
    result.most_ms = std::max(result.most_ms, std::abs(off[i] - sorted[off.size() / 2]));
    if (i > 0) result.step_ms = std::max(result.step_ms, std::abs(off[i] - off[i - 1]));
  }
  return result;
}

/// Stamps that come late by up to so much, as if at random.
std::vector<std::int64_t> late_by(std::vector<std::int64_t> stamps, std::int64_t most) {
  std::uint64_t state = 12345;
  for (std::int64_t& stamp : stamps) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    stamp += static_cast<std::int64_t>((state >> 33U) % static_cast<std::uint64_t>(most));
  }
  return stamps;
}

TEST(StampSteadying, StampsThatComeAndGoBesideSteadySweepsAreSteadied) {
  std::vector<std::int64_t> right = regular(300);
  for (std::size_t i = 100; i < right.size(); ++i) right[i] += 3 * kSecond / 10;  // three missing
  for (std::size_t i = 200; i < right.size(); ++i) right[i] += 30 * kSecond;      // a pause
  const Repaired result = repaired_sweeps(late_by(right, 80'000'000));
  const Off off = off_by(result.stamps, right);
  EXPECT_LT(off.most_ms, 20.0);
  EXPECT_LT(off_by(late_by(right, 80'000'000), right).step_ms, 81.0);
  EXPECT_LT(off.step_ms, 20.0);
  ASSERT_EQ(result.notes.size(), 2U);  // the pause, too
  EXPECT_NE(result.notes[0].find("come and go"), std::string::npos) << result.notes[0];
}

TEST(StampSteadying, AFewThatAreMuchTooLateMoveNothing) {
  std::vector<std::int64_t> stamps = late_by(regular(200), 50'000'000);
  for (std::size_t i = 5; i < stamps.size(); i += 9) stamps[i] += 90'000'000;
  const Off off = off_by(repaired_sweeps(stamps).stamps, regular(200));
  EXPECT_LT(off.most_ms, 15.0);
}

TEST(StampSteadying, NothingIsDoneWhereItIsNotClear) {
  const std::vector<std::int64_t> little = late_by(regular(60), 3'000'000);
  EXPECT_EQ(repaired_sweeps(little).stamps, little) << "a few milliseconds";
  const std::vector<std::int64_t> much = late_by(regular(60), 60'000'000);
  EXPECT_EQ(repaired_sweeps(much, 20'000'000).stamps, much) << "pauses between sweeps";
  EXPECT_EQ(repaired(much).stamps, much) << "no times";
  OpenOptions live;
  live.repair_at_once = true;
  EXPECT_EQ(repaired_sweeps(little, 99'900'000, live).stamps, little);
  EXPECT_EQ(repaired_sweeps(much, 20'000'000, live).stamps, much);
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

/// Without the first ones, from which live runs learn.
Off off_by_after(std::size_t first, const std::vector<std::int64_t>& stamps,
                 const std::vector<std::int64_t>& right) {
  const auto skipped = static_cast<std::ptrdiff_t>(first);
  return off_by({stamps.begin() + skipped, stamps.end()}, {right.begin() + skipped, right.end()});
}

TEST(StampSteadying, LiveRunsLearnFromTheFirstScans) {
  OpenOptions live;
  live.repair_at_once = true;
  std::vector<std::int64_t> right = regular(300);
  for (std::size_t i = 100; i < right.size(); ++i) right[i] += 3 * kSecond / 10;  // three missing
  for (std::size_t i = 200; i < right.size(); ++i) right[i] += 30 * kSecond;      // a pause
  const std::vector<std::int64_t> given = late_by(right, 80'000'000);
  const Repaired result = repaired_sweeps(given, 99'900'000, live);
  ASSERT_EQ(result.stamps.size(), right.size());
  for (std::size_t i = 0; i < 29; ++i) EXPECT_EQ(result.stamps[i], given[i]) << i;
  EXPECT_GT(off_by_after(29, given, right).step_ms, 60.0);
  EXPECT_LT(off_by_after(29, result.stamps, right).step_ms, 40.0) << "behind the pause, too";
  const auto part = [](const std::vector<std::int64_t>& all, std::ptrdiff_t from,
                       std::ptrdiff_t upto) {
    return std::vector<std::int64_t>(all.begin() + from, all.begin() + upto);
  };
  EXPECT_LT(off_by(part(result.stamps, 29, 100), part(right, 29, 100)).step_ms, 11.0);
  EXPECT_LT(off_by(part(result.stamps, 103, 200), part(right, 103, 200)).step_ms, 11.0);
  EXPECT_LT(off_by(part(result.stamps, 103, 200), part(right, 103, 200)).most_ms, 20.0);
  ASSERT_EQ(result.notes.size(), 2U);
  EXPECT_NE(result.notes[0].find("come and go"), std::string::npos) << result.notes[0];
}

double late_ms(std::int64_t stamp_ns, std::int64_t right_ns) {
  return 1e-6 * static_cast<double>(stamp_ns - right_ns);
}

// One may be late by a sweep; three say that a scan is missing.
TEST(StampSteadying, LiveALateScanIsNoMissingOne) {
  OpenOptions live;
  live.repair_at_once = true;
  const std::vector<std::int64_t> right = regular(200);
  std::vector<std::int64_t> given = late_by(right, 60'000'000);
  for (std::size_t i = 50; i < 200; i += 30) given[i] += 90'000'000;
  const std::vector<std::int64_t> stamps = repaired_sweeps(given, 99'900'000, live).stamps;
  for (std::size_t i = 40; i < 200; ++i) EXPECT_NEAR(late_ms(stamps[i], right[i]), 30.0, 25.0);
}

TEST(StampSteadying, LiveASingleMissingScanIsKnownByTheThirdBehindIt) {
  OpenOptions live;
  live.repair_at_once = true;
  std::vector<std::int64_t> right = regular(140);
  for (std::size_t i = 90; i < right.size(); ++i) right[i] += kSecond / 10;
  const std::vector<std::int64_t> given = late_by(right, 60'000'000);
  const std::vector<std::int64_t> stamps = repaired_sweeps(given, 99'900'000, live).stamps;
  for (std::size_t i = 40; i < 140; ++i) {
    if (i >= 90 && i < 92) continue;
    EXPECT_NEAR(late_ms(stamps[i], right[i]), 30.0, 25.0) << i;
  }
}

TEST(StampSteadying, ScansThatArePassedOverChangeNoOther) {
  const std::vector<std::int64_t> given = late_by(regular(120), 80'000'000);
  const auto recording = repair_stamps(std::make_unique<Swept>(given, 99'900'000), {});
  std::vector<std::int64_t> stamps, right;
  for (std::size_t i = 0; i < given.size(); i += 3) {
    stamps.push_back(recording->next()->scan->stamp_ns);
    right.push_back(regular(120)[i]);
    recording->skip(2);
    recording->skip(0);
  }
  EXPECT_LT(off_by(stamps, right).most_ms, 20.0);
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

/// Scans of a regular recording by their numbers, some of them once more.
class SentAgain : public Stamped {
 public:
  explicit SentAgain(std::vector<std::size_t> numbers)
      : Stamped(stamps_of(numbers)), numbers_(std::move(numbers)) {}
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (item) item->scan->points.front().z() = static_cast<float>(numbers_[next_++]);
    return item;
  }

 private:
  static std::vector<std::int64_t> stamps_of(const std::vector<std::size_t>& numbers) {
    std::vector<std::int64_t> stamps;
    for (const std::size_t number : numbers) stamps.push_back(regular(number + 1).back());
    return stamps;
  }
  std::vector<std::size_t> numbers_;
  std::size_t next_ = 0;
};

// A player that goes back by twelve scans, and a driver that repeats every one.
TEST(StampRepair, ScansThatAreSentAgainAreLeftOut) {
  std::vector<std::size_t> block, stuttering;
  for (std::size_t i = 0; i < 20; ++i) block.push_back(i);
  for (std::size_t i = 8; i < 30; ++i) block.push_back(i);
  for (std::size_t i = 0; i < 30; ++i) stuttering.insert(stuttering.end(), {i, i > 0 ? i - 1 : i});
  for (const bool at_once : {false, true}) {
    OpenOptions options;
    options.repair_at_once = at_once;
    for (const auto& numbers : {block, stuttering}) {
      const Repaired result = repaired(std::make_unique<SentAgain>(numbers), options);
      EXPECT_EQ(result.stamps, regular(30)) << at_once;
      ASSERT_EQ(result.notes.size(), 1U);
      EXPECT_NE(result.notes[0].find("sent again, first scan "), std::string::npos)
          << result.notes[0];
    }
  }
}

// The same stamps, and what is seen differs: a clock that was set back, as ever.
TEST(StampRepair, OtherScansAtStampsThatWereThereAreNone) {
  std::vector<std::int64_t> stamps = regular(20);
  for (std::size_t i = 12; i < 20; ++i) stamps[i] -= kSecond;
  EXPECT_EQ(repaired(stamps).stamps, regular(20));
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

}  // namespace
}  // namespace surefoot::io
