// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps that come and go beside steady sweeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/io/stamped_recording.hpp"

namespace surefoot::io {
namespace {

using namespace test;  // NOLINT: the recordings of the test support

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

}  // namespace
}  // namespace surefoot::io
