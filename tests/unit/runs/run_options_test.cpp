// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_options.hpp"

#include <gtest/gtest.h>

#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

Pose mount_of(const RunOptions& options) { return mount_pose(config_of(options).level); }

void expect_same_mount(const Pose& actual, const Pose& expected) {
  EXPECT_NEAR(actual.rotation.angularDistance(expected.rotation), 0.0, 1e-7);
  EXPECT_NEAR((actual.translation - expected.translation).norm(), 0.0, 1e-9);
}

TEST(RunOptions, AMountIsTheSameByAnyOfItsAngles) {
  RunOptions options, other;
  options.extrinsic = {0.3, 0.0, -0.05, 0.0, 164.9, 0.0};
  other.extrinsic = {0.3, 0.0, -0.05, 180.0, 15.1, 180.0};
  expect_same_mount(mount_of(options), mount_of(other));
  options.extrinsic[3] = options.extrinsic[5] = 360.0;
  expect_same_mount(mount_of(options), mount_of(other));
  options.extrinsic[3] = 361.0;
  EXPECT_THROW((void)config_of(options), ConfigError);
}

TEST(RunOptions, ARobotsMountIsThatOfItsOwnLidarAlone) {
  RunOptions options;
  options.reader.robot = "go2";
  EXPECT_EQ(config_of(options).level.mode, LevelMode::mount);
  EXPECT_LT((mount_of(options).rotation * Eigen::Vector3d::UnitZ()).z(), -0.9) << "upside down";
  options.reader.topic = "/utlidar/cloud";
  EXPECT_EQ(config_of(options).level.mode, LevelMode::mount);
  options.level = "none";
  EXPECT_EQ(config_of(options).level.mode, LevelMode::none);
  options.level.clear();
  options.reader.topic = "/livox/lidar";
  EXPECT_EQ(config_of(options).level.mode, LevelMode::ground);
  options.extrinsic = {0.0, 0.0, 0.3, 0.0, 0.0, 0.0};
  EXPECT_EQ(mount_of(options).translation.z(), 0.3);
}

// As a run.yaml has them.
using KnownMount = test::Scratch;
TEST_F(KnownMount, GivesWayToWhatAFileSays) {
  RunOptions options;
  options.reader.robot = "go2";
  options.config_file = write("mount.yaml", "level: {mode: mount, mount_z: 0.5}\n");
  EXPECT_EQ(mount_of(options).translation.z(), 0.5);
  options.config_file = write("ground.yaml", "level: {mode: ground}\n");
  EXPECT_EQ(config_of(options).level.mode, LevelMode::ground);
  options.extrinsic = {0.0, 0.0, 0.3, 0.0, 0.0, 0.0};
  EXPECT_EQ(mount_of(options).translation.z(), 0.3);
}

}  // namespace
}  // namespace surefoot::runs
