// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The level frame from the ground of the first scan.
#include "core/level.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/scene.hpp"
#include "unit/core/look.hpp"

namespace surefoot {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Pose sensor(double height, double roll_deg, double pitch_deg, double yaw_deg = 0.0) {
  return {from_roll_pitch_yaw({roll_deg * kDegree, pitch_deg * kDegree, yaw_deg * kDegree}),
          {0.0, 0.0, height}};
}

Config::Level ground_config() {
  Config::Level config = Config().level;
  config.mode = LevelMode::ground;
  config.max_tilt_deg = 45.0;
  return config;
}

/// Angle between the map's up, as found, and the world's [deg].
double level_error_deg(const Pose& T_map_lidar, const Pose& T_world_lidar) {
  const Eigen::Vector3d up_lidar = T_world_lidar.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d up = T_map_lidar.rotation * up_lidar;
  return std::acos(std::min(1.0, up.z())) / kDegree;
}

TEST(Level, FindsTheGroundUnderTiltedMounts) {
  for (const double pitch : {-15.0, 0.0, 15.0, 25.0}) {
    for (const double roll : {-20.0, 0.0, 8.0}) {
      const Pose T_world_lidar = sensor(0.45, roll, pitch, 33.0);
      LevelReport report;
      const Pose T =
          level_pose(test::look(test::furnished_hall(), T_world_lidar), ground_config(), report);
      ASSERT_TRUE(report.from_ground) << "pitch " << pitch << " roll " << roll;
      // Ranges have 1 cm of noise over some hundred ground points several metres apart.
      EXPECT_LT(level_error_deg(T, T_world_lidar), 0.2) << "pitch " << pitch << " roll " << roll;
      EXPECT_NEAR(report.ground_height, 0.45, 0.02);
      const double tilt =
          std::acos((T_world_lidar.rotation * Eigen::Vector3d::UnitZ()).z()) / kDegree;
      EXPECT_NEAR(report.tilt_deg, tilt, 0.2);
    }
  }
}

TEST(Level, KeepsHeadingAndOrigin) {
  LevelReport report;
  const Pose T = level_pose(test::look(test::furnished_hall(), sensor(0.45, 0.0, 15.0)),
                            ground_config(), report);
  EXPECT_EQ(T.translation, Eigen::Vector3d::Zero());
  EXPECT_NEAR(roll_pitch_yaw(T.rotation).z(), 0.0, 0.5 * kDegree);
}

TEST(Level, TheSameCloudGivesTheSameBits) {
  const auto cloud = test::look(test::furnished_hall(), sensor(0.45, 3.0, 5.0));
  LevelReport report;
  const Pose once = level_pose(cloud, ground_config(), report);
  const Pose twice = level_pose(cloud, ground_config(), report);
  EXPECT_EQ(once.rotation.coeffs(), twice.rotation.coeffs());
}

TEST(Level, OnARampTheRampIsTheGround) {
  // Half-way up: the only ground near the feet is the slope itself.
  test::Scene slope;
  slope.add({sensor(-1.0, 0.0, -10.0), {30.0, 30.0, 1.0}});
  const auto ground = find_ground(test::look(slope, sensor(0.5, 0.0, 0.0)), 45.0);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(std::acos(ground->normal.z()) / kDegree, 10.0, 0.3);
}

TEST(Level, ACeilingIsNotTaken) {
  test::Scene ceiling;
  ceiling.add(test::box_between({-20, -20, 2.0}, {20, 20, 3.0}));
  EXPECT_FALSE(find_ground(test::look(ceiling, sensor(0.0, 0.0, 0.0)), 45.0));
  // A large ceiling close above and a floor: the floor.
  test::Scene both;
  both.add(test::box_between({-20, -20, 0.0}, {20, 20, 1.5}));
  const auto ground = find_ground(test::look(both, sensor(0.9, 0.0, 0.0)), 45.0);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height, 0.9, 0.03);
}

TEST(Level, ATableTopIsNotTaken) {
  test::Scene scene = test::furnished_hall();
  scene.add(test::box_between({1.0, -3.0, 0.25}, {5.0, 3.0, 0.3}));
  const auto ground = find_ground(test::look(scene, sensor(0.45, 0.0, 0.0)), 45.0);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height, 0.45, 0.05);
}

TEST(Level, WithoutGroundItSaysSoAndTakesTheLidarsAxis) {
  test::Scene walls;
  walls.add(test::box_between({-12.0, 6.0, -9.0}, {12.0, 7.0, 9.0}));
  walls.add(test::box_between({-12.0, -7.0, -9.0}, {12.0, -6.0, 9.0}));
  LevelReport report;
  const Pose T = level_pose(test::look(walls, sensor(0.0, 0.0, 0.0)), ground_config(), report);
  EXPECT_FALSE(report.from_ground);
  EXPECT_NE(report.message.find("no ground"), std::string::npos);
  EXPECT_EQ(T.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
}

TEST(Level, ALidarUpsideDownIsTold) {
  LevelReport report;
  const Pose T = level_pose(test::look(test::furnished_hall(), sensor(0.45, 180.0, 5.0)),
                            ground_config(), report);
  EXPECT_FALSE(report.from_ground);
  EXPECT_NE(report.message.find("upside down"), std::string::npos) << report.message;
  // Its mount is Ry(5) Rx(180).
  EXPECT_NE(report.message.find("0,0,0,180,5 "), std::string::npos) << report.message;
  EXPECT_NEAR(level_error_deg(T, sensor(0.45, 180.0, 5.0)), 180.0, 2.0);
}

TEST(Level, AMountThatTheGroundContradictsIsTold) {
  Config::Level config = ground_config();
  config.mode = LevelMode::mount;
  const auto cloud = test::look(test::furnished_hall(), sensor(0.45, 0.0, 15.0));
  LevelReport report;
  for (const double pitch_deg : {15.0, 8.0}) {  // the mount itself, and one not far off it
    config.mount_pitch_deg = pitch_deg;
    (void)level_pose(cloud, config, report);
    EXPECT_EQ(report.message.find("off it"), std::string::npos) << report.message;
  }
  config.mount_pitch_deg = 165.0;
  (void)level_pose(cloud, config, report);
  EXPECT_NE(report.message.find("floor above"), std::string::npos) << report.message;
  config.mount_pitch_deg = 15.0 * kDegree;  // in radians, by mistake
  (void)level_pose(cloud, config, report);
  EXPECT_NE(report.message.find("15 deg off it"), std::string::npos) << report.message;
  config.mount_pitch_deg = 75.0;
  (void)level_pose(cloud, config, report);
  EXPECT_NE(report.message.find("60 deg off it"), std::string::npos) << report.message;
}

TEST(Level, APlaneSteeperThanTheLimitIsNotTheGround) {
  const auto cloud = test::look(test::furnished_hall(), sensor(0.45, 0.0, 25.0));
  EXPECT_TRUE(find_ground(cloud, 30.0));
  EXPECT_FALSE(find_ground(cloud, 20.0));
}

TEST(Level, FewPointsHaveNoGround) {
  EXPECT_FALSE(find_ground({}, 45.0));
  EXPECT_FALSE(find_ground({{1.0F, 0.0F, -0.5F}, {0.0F, 1.0F, -0.5F}, {1.0F, 1.0F, -0.5F}}, 45.0));
}

TEST(Level, AGivenMountAndNoneOverrideTheGround) {
  Config::Level config = ground_config();
  config.mode = LevelMode::mount;
  config.mount_x = 0.3;
  config.mount_pitch_deg = 15.0;
  const auto cloud = test::look(test::furnished_hall(), sensor(0.45, 0.0, 15.0));
  LevelReport report;
  const Pose T = level_pose(cloud, config, report);
  EXPECT_LT((roll_pitch_yaw(T.rotation) - Eigen::Vector3d(0, 15.0 * kDegree, 0)).norm(), 1e-12);
  EXPECT_EQ(T.translation, Eigen::Vector3d(0.3, 0.0, 0.0));
  EXPECT_NEAR(report.tilt_deg, 15.0, 1e-9);
  config.mode = LevelMode::none;
  EXPECT_EQ(level_pose(cloud, config, report).matrix(), Eigen::Matrix4d::Identity());
  EXPECT_FALSE(report.from_ground);
  EXPECT_FALSE(report.message.empty());
}

}  // namespace
}  // namespace surefoot
