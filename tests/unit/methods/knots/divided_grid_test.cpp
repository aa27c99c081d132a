// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT

// The finest grid as the default has it: it divides voxels of the next one.

#include <gtest/gtest.h>

#include <utility>

#include "support/random.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using test::cloud;
using test::knots_config;
using test::Points;
using test::Random;
using test::remove_all_far;

const Eigen::Vector3d kHere(0.0, 0.0, 0.6);

/// A finest grid of 0.2 m over one of 0.4 m.
Config::Knots dividing() {
  Config::Knots config = knots_config();
  config.finest_voxel = 0.2;
  config.levels = 5;
  config.divided_at = 12;
  return config;
}

/// A wall across the way, so many points per square metre.
Points wall(double x, int density) {
  Random random(21);
  return cloud(random, 4 * density, {x, 0.1, 1.1}, Eigen::Matrix3d::Identity(), {0.0, 1.0, 1.0},
               0.005);
}

int level_found(const SurfelMap& map, const Eigen::Vector3d& place) {
  SurfelMap::Place fresh;
  (void)test::find_again(map, place, place - kHere, 0, fresh);
  return fresh.level;
}

int level_at_wall(const SurfelMap& map, double x) { return level_found(map, {x, 0.1, 1.1}); }

TEST(DividedGrid, AVoxelIsDividedOnceItIsFull) {
  SurfelMap map(dividing(), 100.0);
  map.insert({kHere, wall(5.1, 1000)});
  EXPECT_EQ(level_at_wall(map, 5.1), 1);
  map.insert({kHere, wall(5.1, 1000)});
  EXPECT_EQ(level_at_wall(map, 5.1), 0);
}

TEST(DividedGrid, AVoxelOfFewPointsIsNot) {
  SurfelMap map(dividing(), 100.0);
  map.insert({kHere, wall(5.1, 10)});    // not two in a voxel of 0.4 m
  map.insert({kHere, wall(5.1, 1000)});  // had they been enough, this would do
  EXPECT_EQ(level_at_wall(map, 5.1), 1);
}

TEST(DividedGrid, WhatIsFarIsNot) {
  for (const double x : {15.1, 25.1}) {
    SurfelMap map(dividing(), 100.0);
    for (int i = 0; i < 3; ++i) map.insert({kHere, wall(x, 1000)});
    EXPECT_EQ(level_at_wall(map, x), x < 20.0 ? 0 : 1) << x;
  }
}

TEST(DividedGrid, WhatGoesFarLosesItAndKeepsTheNext) {
  SurfelMap map(dividing(), 100.0);
  for (int i = 0; i < 2; ++i) map.insert({kHere, wall(5.1, 1000)});
  remove_all_far(map, kHere);
  ASSERT_EQ(level_at_wall(map, 5.1), 0);
  remove_all_far(map, kHere - Eigen::Vector3d(20.0, 0.0, 0.0));
  EXPECT_EQ(level_at_wall(map, 5.1), 1);
}

TEST(DividedGrid, WhatTheNextEmptiesIsEmpty) {
  SurfelMap map(dividing(), 100.0);
  for (int i = 0; i < 3; ++i) map.insert({kHere, wall(5.1, 1000)});
  ASSERT_EQ(level_at_wall(map, 5.1), 0);
  Cubes emptied;
  for (int i = 0; i < 6 && emptied.centres.empty(); ++i) {
    emptied = map.insert({kHere, wall(12.1, 4000)});
  }
  ASSERT_FALSE(emptied.centres.empty());
  EXPECT_EQ(emptied.side, 0.4);
  for (const Eigen::Vector3d& centre : emptied.centres) {
    for (const double y : {-0.1, 0.1}) {
      const Eigen::Vector3d part(5.1, centre.y() + y, centre.z() + y);
      const int level = level_found(map, part);
      EXPECT_TRUE(level != 0 && level != 1) << level << " at " << part.transpose();
    }
  }
}

/// A fifth of the voxels below zero have middles that are rounded into a voxel that is not theirs.
TEST(DividedGrid, SoItIsBelowZero) {
  const Eigen::Vector3d far_off(0.0, -12.0, -12.0);
  const auto seen = [&](double x, int density) {
    Points points = wall(x, density);
    for (Eigen::Vector3d& point : points) point += far_off;
    return View{kHere + far_off, std::move(points)};
  };
  SurfelMap map(dividing(), 100.0);
  for (int i = 0; i < 3; ++i) map.insert(seen(5.1, 1000));
  Cubes emptied;
  for (int i = 0; i < 6 && emptied.centres.empty(); ++i) emptied = map.insert(seen(12.1, 4000));
  ASSERT_FALSE(emptied.centres.empty());
  for (const Eigen::Vector3d& centre : emptied.centres) {
    for (const double y : {-0.1, 0.1}) {
      for (const double z : {-0.1, 0.1}) {
        const Eigen::Vector3d part(5.1, centre.y() + y, centre.z() + z);
        SurfelMap::Place fresh;
        (void)test::find_again(map, part, part - kHere - far_off, 0, fresh);
        EXPECT_TRUE(fresh.level != 0 && fresh.level != 1)
            << fresh.level << " at " << part.transpose();
      }
    }
  }
}

TEST(DividedGrid, WithoutItTheFinestTakesAllAndAsksTheBeams) {
  Config::Knots config = dividing();
  config.divided_at = 0;
  SurfelMap map(config, 100.0);
  map.insert({kHere, wall(25.1, 1000)});
  EXPECT_EQ(level_at_wall(map, 25.1), 0);
  Cubes emptied;
  for (int i = 0; i < 6 && emptied.centres.empty(); ++i) {
    emptied = map.insert({kHere, wall(40.1, 20'000)});
  }
  EXPECT_FALSE(emptied.centres.empty());
  EXPECT_EQ(emptied.side, 0.2);
}

}  // namespace
}  // namespace surefoot
