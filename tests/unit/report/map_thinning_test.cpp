// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/map_thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace surefoot::report {
namespace {

/// A floor of 200 x 200 points, 0.1 m apart.
std::vector<Eigen::Vector3f> floor_points() {
  std::vector<Eigen::Vector3f> points;
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 200; ++y) points.emplace_back(0.1F * float(x), 0.1F * float(y), 0.0F);
  }
  return points;
}

TEST(MapThinning, KeepsEverythingThatFits) {
  const auto points = floor_points();
  const ThinnedCloud all = thin_cloud(points, points.size());
  EXPECT_EQ(all.kept.size(), points.size());
  EXPECT_EQ(all.cube, 0.0);
  EXPECT_TRUE(thin_cloud({}, 1).kept.empty());
}

TEST(MapThinning, OnePointACubeAndCloseToTheBudget) {
  const auto points = floor_points();
  const ThinnedCloud thinned = thin_cloud(points, 5000);
  EXPECT_LE(thinned.kept.size(), 5000U);
  EXPECT_GE(thinned.kept.size(), 3500U);
  EXPECT_TRUE(std::is_sorted(thinned.kept.begin(), thinned.kept.end()));
  std::set<std::tuple<int, int>> cubes;
  for (const std::uint32_t i : thinned.kept) {
    const auto index = [&](float value) { return int(std::floor(double{value} / thinned.cube)); };
    EXPECT_TRUE(cubes.emplace(index(points[i].x()), index(points[i].y())).second);
  }
}

TEST(MapThinning, LeavesOutWhatIsNotFinite) {
  auto points = floor_points();
  points[7].x() = std::numeric_limits<float>::quiet_NaN();
  points[9].z() = std::numeric_limits<float>::infinity();
  EXPECT_EQ(thin_cloud(points, points.size()).kept.size(), points.size() - 2);
  for (const std::uint32_t i : thin_cloud(points, 1000).kept) EXPECT_TRUE(points[i].allFinite());
}

TEST(MapThinning, EndsForCloudsThatNoCubeSeparates) {
  const std::vector<Eigen::Vector3f> same(1000, Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(thin_cloud(same, 10).kept.size(), 1U);
  std::vector<Eigen::Vector3f> heap(1000, Eigen::Vector3f(1, 2, 3));
  heap.emplace_back(3e38F, -3e38F, 0.0F);
  const ThinnedCloud thinned = thin_cloud(heap, 10);
  EXPECT_EQ(thinned.kept.size(), 2U);
  EXPECT_EQ(thin_cloud(floor_points(), 1).kept.size(), 1U);
}

TEST(MapThinning, RefusesABudgetOfNothing) {
  EXPECT_THROW((void)thin_cloud(floor_points(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::report
