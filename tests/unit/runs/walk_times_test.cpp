// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/walk_times.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::runs {
namespace {

constexpr std::int64_t kTick = 100'000'000;

/// Of scans at so many tenths of a second; those without a pose are told in `missing`.
std::vector<std::int64_t> tenths(std::vector<std::int64_t> stamps,
                                 const std::vector<std::size_t>& missing = {}) {
  std::vector<std::optional<Pose>> poses(stamps.size(), Pose{});
  for (const std::size_t scan : missing) poses[scan] = std::nullopt;
  for (std::int64_t& stamp : stamps) stamp *= kTick;
  std::vector<std::int64_t> times = walk_times(stamps, poses);
  for (std::int64_t& time : times) time /= kTick;
  return times;
}

using Tenths = std::vector<std::int64_t>;

TEST(WalkTimes, AreTheStampsOfAClockThatGoesOn) {
  EXPECT_EQ(tenths({5, 6, 8, 9}, {0, 2, 3}), (Tenths{5, 6, 8, 9}));
  EXPECT_EQ(tenths({5, 6, 8}, {0, 1, 2}), (Tenths{5, 6, 8}));
  EXPECT_TRUE(tenths({}).empty());
}

TEST(WalkTimes, GoOnWhereTheClockWasSetBack) {
  EXPECT_EQ(tenths({0, 1, -3000, -2999}), (Tenths{0, 1, 11, 12}));
  // Most of a second is refused before the odometry follows.
  EXPECT_EQ(tenths({0, 1, -3000, -2999, -2993, -2992}, {2, 3}), (Tenths{0, 1, 4, 5, 11, 12}));
}

TEST(WalkTimes, AscendWhateverScansWithoutAPoseAreStamped) {
  EXPECT_EQ(tenths({0, 9000, 2, -9000, 4, 3}, {1, 3, 5}), (Tenths{0, 2, 2, 2, 4, 4}));
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  const std::vector<std::optional<Pose>> poses = {Pose{}, std::nullopt, std::nullopt};
  const std::vector<std::int64_t> times = walk_times({7, kLeast, kLeast}, poses);
  EXPECT_EQ(times, (std::vector<std::int64_t>{7, 7, 7}));
}

}  // namespace
}  // namespace surefoot::runs
