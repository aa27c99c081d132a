// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Thinning by cubes that follow the scale of the scene.
#include "methods/paper/thin_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/downsample.hpp"
#include "support/random_cloud.hpp"

namespace surefoot {
namespace {

using test::Random;
using test::random_cloud;
using test::shuffle;

PaperParameters::Downsample cubes(double map_voxel, double source_voxel, int min_points) {
  PaperParameters::Downsample config;
  config.map_voxel = map_voxel;
  config.source_voxel = source_voxel;
  config.min_points = min_points;
  return config;
}

/// Both clouds with cubes `halvings` times halved.
ThinnedScan thinned_at(const std::vector<Eigen::Vector3f>& cloud,
                       const PaperParameters::Downsample& config, int halvings) {
  const double scale = std::ldexp(1.0, -halvings);
  ThinnedScan thinned;
  thinned.map_points = downsample(cloud, scale * config.map_voxel);
  thinned.source_points = downsample(thinned.map_points, scale * config.source_voxel);
  return thinned;
}

void expect_equal(const ThinnedScan& a, const ThinnedScan& b) {
  EXPECT_EQ(a.map_points, b.map_points);
  EXPECT_EQ(a.source_points, b.source_points);
}

TEST(ThinScan, ADenseSceneKeepsTheCubesItWasGiven) {
  const auto cloud = random_cloud(5, 20'000, 20.0);
  const PaperParameters::Downsample config = cubes(0.5, 2.0, 400);
  const ThinnedScan expected = thinned_at(cloud, config, 0);
  ASSERT_GE(expected.source_points.size(), 400U);
  expect_equal(thin_scan(cloud, config), expected);
}

TEST(ThinScan, CubesAreHalvedJustOftenEnough) {
  // Ever smaller rooms; the last halving is the one that was needed.
  for (const auto& [half, halvings] : {std::pair{3.9, 1}, {1.95, 2}, {0.97, 3}, {0.48, 4}}) {
    const auto cloud = random_cloud(6, 20'000, half);
    const PaperParameters::Downsample config = cubes(0.4, 2.0, 400);
    ASSERT_LT(thinned_at(cloud, config, halvings - 1).source_points.size(), 400U);
    ASSERT_GE(thinned_at(cloud, config, halvings).source_points.size(), 400U);
    expect_equal(thin_scan(cloud, config), thinned_at(cloud, config, halvings));
  }
}

TEST(ThinScan, ExactlyEnoughIsEnough) {
  const auto cloud = random_cloud(7, 20'000, 3.9);
  PaperParameters::Downsample config = cubes(0.4, 2.0, 0);
  config.min_points = static_cast<int>(thinned_at(cloud, config, 0).source_points.size());
  expect_equal(thin_scan(cloud, config), thinned_at(cloud, config, 0));
  ++config.min_points;
  expect_equal(thin_scan(cloud, config), thinned_at(cloud, config, 1));
}

TEST(ThinScan, WhereNothingIsGainedTheFinestIsReturned) {
  const auto cloud = random_cloud(8, 50, 0.4);  // 50 points never become 400
  const PaperParameters::Downsample config = cubes(0.5, 2.0, 400);
  const ThinnedScan thinned = thin_scan(cloud, config);
  expect_equal(thinned, thinned_at(cloud, config, 4));
  EXPECT_GT(thinned.source_points.size(), thinned_at(cloud, config, 3).source_points.size());
  EXPECT_TRUE(thin_scan({}, config).map_points.empty());
  const std::vector<Eigen::Vector3f> one(700, Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(thin_scan(one, config).source_points.size(), 1U);
}

TEST(ThinScan, SourcePointsAreAmongTheMapPoints) {
  for (const double half : {0.5, 2.0, 20.0}) {
    const ThinnedScan thinned = thin_scan(random_cloud(9, 8000, half), cubes(0.3, 1.7, 400));
    EXPECT_LE(thinned.source_points.size(), thinned.map_points.size());
    for (const auto& p : thinned.source_points) {
      ASSERT_NE(std::find(thinned.map_points.begin(), thinned.map_points.end(), p),
                thinned.map_points.end());
    }
  }
}

TEST(ThinScan, OrderOfThePointsDoesNotChangeABit) {
  Random random(10);
  for (const double half : {0.5, 2.0, 20.0}) {
    auto cloud = random_cloud(11, 5000, half);
    const PaperParameters::Downsample config = cubes(0.3, 1.7, 400);
    const ThinnedScan expected = thin_scan(cloud, config);
    for (int round = 0; round < 3; ++round) {
      shuffle(cloud, random);
      expect_equal(thin_scan(cloud, config), expected);
    }
  }
}

}  // namespace
}  // namespace surefoot
