// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/bounded_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace surefoot::runs {
namespace {

StampedPose pose_at(std::int64_t stamp_ns) {
  StampedPose pose;
  pose.stamp_ns = stamp_ns;
  pose.pose.translation.x() = static_cast<double>(stamp_ns);
  return pose;
}

std::vector<std::int64_t> stamps(const BoundedPath& path) {
  std::vector<std::int64_t> stamps;
  for (const StampedPose& pose : path.poses()) stamps.push_back(pose.stamp_ns);
  return stamps;
}

using Stamps = std::vector<std::int64_t>;

TEST(BoundedPath, HoldsAllThatItHasRoomFor) {
  BoundedPath path(4);
  for (int i = 0; i < 4; ++i) path.add(pose_at(i));
  EXPECT_EQ(stamps(path), (Stamps{0, 1, 2, 3}));
}

TEST(BoundedPath, DoublesItsSpacingWhenItIsFull) {
  BoundedPath path(4);
  for (int i = 0; i < 5; ++i) path.add(pose_at(i));
  EXPECT_EQ(stamps(path), (Stamps{0, 2, 4}));
  path.add(pose_at(5));
  EXPECT_EQ(stamps(path), (Stamps{0, 2, 4, 5}));
  path.add(pose_at(6));
  EXPECT_EQ(stamps(path), (Stamps{0, 2, 4, 6}));
  path.add(pose_at(7));
  EXPECT_EQ(stamps(path), (Stamps{0, 4, 7}));
  path.add(pose_at(8));
  path.add(pose_at(9));
  EXPECT_EQ(stamps(path), (Stamps{0, 4, 8, 9}));
  EXPECT_EQ(path.added(), 10U);
}

TEST(BoundedPath, IsNeverLongerAndHasTheFirstAndTheNewestAtEvenSpacing) {
  for (const std::size_t most : {2U, 3U, 5U, 64U, 100U}) {
    BoundedPath path(most);
    for (std::int64_t i = 0; i < 1000; ++i) {
      path.add(pose_at(i));
      const Stamps kept = stamps(path);
      ASSERT_LE(kept.size(), most);
      ASSERT_GT(2 * kept.size(), std::min<std::size_t>(most, path.added()));
      ASSERT_EQ(kept.front(), 0);
      ASSERT_EQ(kept.back(), i);
      for (std::size_t k = 2; k + 1 < kept.size(); ++k) {
        ASSERT_EQ(kept[k] - kept[k - 1], kept[1] - kept[0]);
      }
    }
  }
}

TEST(BoundedPath, NoTroubleGoesUnseen) {
  for (int bad = 0; bad < 500; ++bad) {
    BoundedPath path(8);
    for (int i = 0; i < 500; ++i) path.add(pose_at(i), i == bad, i / 100);
    const auto at = std::find(path.untrusted().begin(), path.untrusted().end(), true);
    ASSERT_NE(at, path.untrusted().end()) << bad;
    EXPECT_EQ(std::count(path.untrusted().begin(), path.untrusted().end(), true), 1);
    const auto index = static_cast<std::size_t>(at - path.untrusted().begin());
    EXPECT_LE(path.poses()[index].stamp_ns, bad);
    EXPECT_TRUE(index + 1 == path.poses().size() || path.poses()[index + 1].stamp_ns > bad);
    EXPECT_EQ(path.segments()[index], path.poses()[index].stamp_ns / 100);
  }
}

TEST(BoundedPath, BeginsAnew) {
  BoundedPath path(4);
  for (int i = 0; i < 9; ++i) path.add(pose_at(i));
  path.clear();
  EXPECT_EQ(path.added(), 0U);
  for (int i = 20; i < 24; ++i) path.add(pose_at(i));
  EXPECT_EQ(stamps(path), (Stamps{20, 21, 22, 23}));
}

}  // namespace
}  // namespace surefoot::runs
