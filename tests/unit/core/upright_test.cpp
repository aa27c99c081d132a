// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Up, by what stands upright and lies level.
#include "core/upright.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/level.hpp"
#include "geometry/so3.hpp"
#include "support/random.hpp"
#include "support/scene.hpp"
#include "unit/core/look.hpp"

namespace surefoot {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSteepest = 45.0;  // [deg]

/// A wall with a gallery, a row of columns and a roof, and no floor.
test::Scene arcade() {
  test::Scene scene;
  scene.add(test::box_between({-15.0, 6.0, -4.0}, {15.0, 6.2, 6.0}));
  scene.add(test::box_between({-15.0, 4.5, 1.6}, {15.0, 6.0, 1.8}));
  scene.add(test::box_between({-15.0, -9.0, 3.0}, {15.0, 6.0, 3.2}));
  for (const double x : {-9.0, -6.0, -3.0, 0.0, 3.0, 6.0, 9.0}) {
    scene.add(test::box_between({x, -5.0, -4.0}, {x + 0.5, -4.5, 3.0}));
  }
  return scene;
}

Pose tilted(double roll_deg, double pitch_deg, double yaw_deg = 20.0) {
  return {from_roll_pitch_yaw({roll_deg * kDegree, pitch_deg * kDegree, yaw_deg * kDegree}),
          {0.0, 0.1, 0.45}};
}

double error_deg(const Eigen::Vector3d& up, const Pose& T_world_lidar) {
  return std::acos(std::clamp((T_world_lidar.rotation * up).z(), -1.0, 1.0)) / kDegree;
}

TEST(Upright, WallsAndWhatLiesLevelTellWhichWayIsUp) {
  for (const double pitch_deg : {-30.0, -12.0, 0.0, 25.0}) {
    for (const double roll_deg : {-20.0, 0.0, 8.0}) {
      for (const test::Scene& scene : {test::furnished_hall(), arcade()}) {
        const Pose T_world_lidar = tilted(roll_deg, pitch_deg);
        const auto up = find_up(test::look(scene, T_world_lidar), kSteepest);
        ASSERT_TRUE(up) << roll_deg << ' ' << pitch_deg;
        EXPECT_NEAR(up->norm(), 1.0, 1e-12);
        EXPECT_LT(error_deg(*up, T_world_lidar), 2.0) << roll_deg << ' ' << pitch_deg;
      }
    }
  }
}

TEST(Upright, IsTheSameWhateverTheOrderOfThePoints) {
  std::vector<Eigen::Vector3f> cloud = test::look(arcade(), tilted(0.0, 28.0));
  const auto up = find_up(cloud, kSteepest);
  std::reverse(cloud.begin(), cloud.end());
  ASSERT_TRUE(up);
  EXPECT_EQ(*up, *find_up(cloud, kSteepest));
}

TEST(Upright, WhatIsSteeperThanTheLimitIsNotLookedFor) {
  const auto cloud = test::look(arcade(), tilted(0.0, 28.0));
  for (const double limit : {20.0, 24.0, 26.0, 28.0, 30.0}) EXPECT_FALSE(find_up(cloud, limit));
}

TEST(Upright, WhereNothingStandsNothingIsTold) {
  test::Random random(7);
  std::vector<Eigen::Vector3f> stones, thicket, slope;
  for (int i = 0; i < 4000; ++i) {
    stones.push_back(random.vector(12.0).cast<float>());
    thicket.push_back(random.vector(3.0).cast<float>());
    const Eigen::Vector3d p = random.vector(12.0);
    slope.emplace_back(p.cast<float>().x(), p.cast<float>().y(), 0.3F * p.cast<float>().x() - 0.5F);
  }
  EXPECT_FALSE(find_up(stones, kSteepest));
  EXPECT_FALSE(find_up(thicket, kSteepest));  // all ways alike
  EXPECT_FALSE(find_up(slope, kSteepest));
  EXPECT_FALSE(find_up({}, kSteepest));
  EXPECT_FALSE(find_up(std::vector<Eigen::Vector3f>(stones.begin(), stones.begin() + 40), 90.0));
}

TEST(Upright, LevelsAMapWhereNoGroundIsFound) {
  const Pose T_world_lidar = tilted(0.0, 28.0);
  const auto cloud = test::look(arcade(), T_world_lidar);
  Config::Level config = Config().level;
  config.max_tilt_deg = kSteepest;
  LevelReport report;
  const Pose T_map_lidar = level_pose(cloud, config, report);
  EXPECT_FALSE(report.from_ground);
  EXPECT_NEAR(report.tilt_deg, 28.0, 2.0);
  EXPECT_NE(report.message.find("stands upright"), std::string::npos) << report.message;
  const Eigen::Vector3d up = T_map_lidar.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(error_deg(up, T_world_lidar), 2.0);
}

}  // namespace
}  // namespace surefoot
