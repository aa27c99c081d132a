// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/map_blur.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace surefoot::checks {
namespace {

/// A wall at x = 3.2, seen from where the sensor stands.
std::vector<Eigen::Vector3f> wall() {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 80; ++i) {
    for (int j = 0; j < 40; ++j) {
      points.emplace_back(3.2F, 0.05F * float(i) - 2.0F, 0.05F * float(j) - 1.0F);
    }
  }
  return points;
}

Pose beside(double x) { return {Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}}; }

TEST(MapBlur, IsHowFarAScanLiesBesideThoseBefore) {
  MapBlur map;
  EXPECT_FALSE(map.add(wall(), beside(0.0)));  // nothing lay there before
  const auto same = map.add(wall(), beside(0.0));
  ASSERT_TRUE(same);
  EXPECT_LT(*same, 1e-5);
  const auto moved = map.add(wall(), beside(0.06));
  ASSERT_TRUE(moved);
  EXPECT_NEAR(*moved, 0.06, 1e-5);
}

TEST(MapBlur, PassesOverWhatIsNoPlace) {
  MapBlur map;
  std::vector<Eigen::Vector3f> points = wall();
  points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F);
  points.emplace_back(1e30F, 0.0F, 0.0F);
  EXPECT_FALSE(map.add(points, beside(0.0)));
  const auto blur = map.add(points, beside(0.0));
  ASSERT_TRUE(blur);
  EXPECT_LT(*blur, 1e-5);
}

}  // namespace
}  // namespace surefoot::checks
