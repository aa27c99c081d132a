// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that do not go with their points' own clock, of which either may be wrong.
#include "io/point_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "io/stamp_repair.hpp"
#include "support/memory_recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kFirst = 1'700'000'000 * kSecond + 123;
constexpr std::int64_t kFarthest = 2 * kSecond;

struct Given {
  std::int64_t stamp_ns = 0, first_ns = 0, logged_ns = 0;
};

/// Scans of two points, a tenth of a second apart, read as absolute times are.
class Clocked : public surefoot::test::MemoryRecording {
 public:
  explicit Clocked(const std::vector<Given>& scans) : MemoryRecording(items_of(scans)) {}

 private:
  static std::vector<ScanItem> items_of(const std::vector<Given>& scans) {
    std::vector<ScanItem> items(scans.size());
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const Given& given = scans[i];
      ScanItem& item = items[i];
      item.name = "scan " + std::to_string(i);
      item.logged_ns = given.logged_ns;
      item.scan.emplace();
      item.scan->stamp_ns = given.stamp_ns;
      item.scan->points.assign(2, {1.0F, 2.0F, static_cast<float>(i)});
      const bool near = std::abs(given.first_ns - given.stamp_ns) < kFarthest;
      const std::int64_t origin = near ? given.stamp_ns : given.first_ns;
      item.clock = PointClock{given.first_ns, origin};
      const auto first = static_cast<std::int32_t>(given.first_ns - origin);
      item.scan->times_ns = {first, first + 100'000'000};
    }
    return items;
  }
};

std::int64_t true_stamp(std::size_t i) {
  return kFirst + static_cast<std::int64_t>(i) * kSecond / 10;
}

/// The points' clock is ahead of the stamps' by so much.
std::vector<Given> regular(std::size_t count, std::int64_t ahead = 0) {
  std::vector<Given> scans;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back({true_stamp(i), true_stamp(i) + ahead, 0});
  }
  return scans;
}

struct Read {
  std::vector<std::int64_t> stamps;
  std::vector<std::int64_t> firsts;  ///< instants of the first points
  std::vector<std::string> notes;
};

Read read(std::vector<Given> scans, bool at_once = false) {
  OpenOptions options;
  options.repair_at_once = at_once;
  const auto recording = repair_stamps(std::make_unique<Clocked>(std::move(scans)), options);
  Read result;
  while (const auto item = recording->next()) {
    result.stamps.push_back(item->scan->stamp_ns);
    result.firsts.push_back(item->scan->stamp_ns + item->scan->times_ns[0]);
  }
  result.notes = recording->notes();
  return result;
}

std::vector<std::int64_t> true_stamps(std::size_t count) {
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < count; ++i) stamps.push_back(true_stamp(i));
  return stamps;
}

void expect_repaired(const std::vector<Given>& scans, const std::string& what) {
  for (const bool at_once : {false, true}) {
    const Read result = read(scans, at_once);
    EXPECT_EQ(result.stamps, true_stamps(scans.size())) << at_once;
    EXPECT_EQ(result.firsts, true_stamps(scans.size())) << at_once;
    ASSERT_EQ(result.notes.size(), 1U) << at_once << result.notes.back();
    EXPECT_NE(result.notes[0].find(what), std::string::npos) << result.notes[0];
  }
}

TEST(PointClock, WhatAgreesIsLeftToTheNanosecond) {
  for (const std::int64_t ahead : {std::int64_t{0}, 37 * kSecond, -kFirst}) {
    std::vector<Given> scans = regular(20, ahead);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      scans[i].stamp_ns += static_cast<std::int64_t>(i * 7'654'321 % 40'000'000);  // arrival
    }
    for (std::size_t i = 12; i < scans.size(); ++i) {  // a gap
      scans[i].stamp_ns += 3 * kSecond / 10;
      scans[i].first_ns += 3 * kSecond / 10;
    }
    const Read result = read(scans);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      EXPECT_EQ(result.stamps[i], scans[i].stamp_ns);
      EXPECT_TRUE(ahead != 0 || result.firsts[i] == scans[i].first_ns);
    }
    EXPECT_TRUE(result.notes.empty());
  }
}

TEST(PointClock, StampsThatStandAreTakenFromThePoints) {
  std::vector<Given> scans = regular(60);
  for (Given& given : scans) given.stamp_ns = kFirst;
  expect_repaired(scans, "stand still at scan 1");
}

TEST(PointClock, AWildStampIsTakenFromThePoints) {
  for (const std::int64_t off : {2 * kSecond / 10, 3 * kSecond, 3600 * kSecond, -3600 * kSecond}) {
    for (const std::size_t at : {1, 9, 19}) {
      std::vector<Given> scans = regular(20);
      scans[at].stamp_ns += off;
      expect_repaired(scans, "that of scan " + std::to_string(at));
    }
  }
}

TEST(PointClock, TheFirstStampIsComparedWithTheNext) {
  for (const std::int64_t off : {kSecond, 3600 * kSecond, -3600 * kSecond, -kFirst}) {
    std::vector<Given> scans = regular(20);
    scans[0].stamp_ns += off;
    const Read result = read(scans);
    EXPECT_EQ(result.stamps, true_stamps(20)) << off;
    EXPECT_EQ(result.firsts, true_stamps(20)) << off;
    EXPECT_EQ(result.notes.size(), 1U);
  }
}

TEST(PointClock, StampsThatAreNoClockAreTakenFromPointsSinceTheEpoch) {
  std::vector<Given> scans = regular(20);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns = static_cast<std::int64_t>((i * 7919) % 1000) * kSecond;
  }
  EXPECT_EQ(read(scans).stamps, true_stamps(20));
  EXPECT_EQ(read(scans).firsts, true_stamps(20));
}

TEST(PointClock, AStampsClockThatIsSetGoesOnAsThePointsDo) {
  for (const std::int64_t by : {3 * kSecond, -kSecond / 5, 3600 * kSecond}) {
    std::vector<Given> scans = regular(30);
    for (std::size_t i = 12; i < 30; ++i) scans[i].stamp_ns += by;
    expect_repaired(scans, "that of scan 12");
  }
}

// The LiDAR learns the time, say.
TEST(PointClock, APointsClockThatIsSetIsFollowed) {
  for (const std::int64_t by : {kSecond, 3600 * kSecond, kFirst}) {
    std::vector<Given> scans = regular(30);
    for (std::size_t i = 0; i < 12; ++i) scans[i].first_ns -= by;
    const Read result = read(scans);
    EXPECT_EQ(result.stamps, true_stamps(30)) << by;
    // Points stay where they were to their stamps.
    for (std::size_t i = 13; i < 30; ++i) {
      EXPECT_EQ(result.firsts[i] - result.stamps[i], result.firsts[0] - result.stamps[0]) << by;
    }
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_NE(result.notes[0].find("their clock is set at scan 12"), std::string::npos)
        << result.notes[0];
  }
}

TEST(PointClock, WhereBothJumpReceiptsTellWhoIsRight) {
  std::vector<Given> scans = regular(20);
  for (std::size_t i = 12; i < 20; ++i) {
    scans[i].stamp_ns += 40 * kSecond;  // both after a gap of five seconds
    scans[i].first_ns += 5 * kSecond;
  }
  std::vector<std::int64_t> expected = true_stamps(20);
  for (std::size_t i = 12; i < 20; ++i) expected[i] += 5 * kSecond;
  for (std::size_t i = 0; i < 20; ++i) scans[i].logged_ns = expected[i] + kSecond / 100;
  EXPECT_EQ(read(scans).stamps, expected);
}

}  // namespace
}  // namespace surefoot::io
