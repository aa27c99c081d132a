// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/outlook.hpp"

#include <gtest/gtest.h>

namespace surefoot::mapping {
namespace {

/// A wall to the north, and ground all about, seen from the middle; and a step aside a single
/// point.
Submap seen_from_middle() {
  Submap submap;
  const auto see = [&](float x, float y, float z) {
    submap.points.emplace_back(x, y, z);
    submap.eyes.emplace_back(0.0F, 0.0F, 0.5F);
  };
  for (float x = -6.0F; x < 6.0F; x += 0.2F) {
    for (float z = 0.0F; z < 3.0F; z += 0.2F) see(x, 10.0F, z);
    for (float y = -6.0F; y < 6.0F; y += 0.2F) see(x, y, 0.0F);
  }
  submap.points.emplace_back(3.0F, 10.0F, 1.0F);
  submap.eyes.emplace_back(3.0F, 0.0F, 0.5F);
  return submap;
}

using Sight = Outlook::Sight;

TEST(Outlook, WhatIsInFreeSightAndNotSeenIsMissing) {
  const Outlook outlook(seen_from_middle(), Eigen::Vector3d::Zero());
  EXPECT_EQ(outlook.at({0.0, 10.0, 1.0}), Sight::seen);
  EXPECT_EQ(outlook.at({2.0, 10.6, 1.0}), Sight::seen);
  EXPECT_EQ(outlook.at({0.0, 20.0, 1.0}), Sight::unknown) << "behind the wall";
  EXPECT_EQ(outlook.at({0.0, 6.0, 0.8}), Sight::missing) << "the wall is seen through it";
  EXPECT_EQ(outlook.at({20.0, 3.0, 1.0}), Sight::missing) << "nothing is seen there";
  EXPECT_EQ(outlook.at({47.0, 5.0, 1.0}), Sight::missing);
  EXPECT_EQ(outlook.at({49.0, 5.0, 1.0}), Sight::unknown) << "too far away";
  EXPECT_EQ(outlook.at({1.0, 1.0, 0.8}), Sight::unknown) << "too near";
  EXPECT_EQ(outlook.at({20.0, 0.0, 9.0}), Sight::unknown) << "above all beams";
  EXPECT_EQ(outlook.at({3.0, 0.0, -6.0}), Sight::unknown) << "below all beams";
}

TEST(Outlook, TheNearestEyeLooks) {
  EXPECT_EQ(Outlook(seen_from_middle(), {2.0, 0.0, 0.5}).eye(), Eigen::Vector3d(3.0, 0.0, 0.5));
  EXPECT_EQ(Outlook(seen_from_middle(), {1.0, 0.0, 0.5}).eye(), Eigen::Vector3d(0.0, 0.0, 0.5));
}

/// Of a submap without points nothing is told.
TEST(Outlook, WhereNothingWasSeenNothingIsMissing) {
  const Outlook outlook(Submap{}, Eigen::Vector3d::Zero());
  EXPECT_EQ(outlook.at({20.0, 3.0, 1.0}), Sight::unknown);
}

}  // namespace
}  // namespace surefoot::mapping
