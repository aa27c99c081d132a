// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// True trajectories as data sets write them.
#include "io/truth_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

TEST(TruthTable, TumWithSpacesOrCommas) {
  for (const char* text : {"# t x y z\n1583836591.182590976 1 2 3 0 0 0 1\n",
                           "t,x,y,z,qx,qy,qz,qw\n1583836591.182590976,1,2,3,0,0,0,1\n"}) {
    const Truth truth = parse_truth_table(text);
    ASSERT_EQ(truth.poses.size(), 1U);
    EXPECT_EQ(truth.poses[0].stamp_ns, 1583836591182590976);
    EXPECT_EQ(truth.poses[0].pose.translation, Eigen::Vector3d(1, 2, 3));
    EXPECT_TRUE(truth.has_rotations);
  }
}

// Newer College's, and parkland_mound's, whose seconds are a decimal number between spaces.
TEST(TruthTable, NewerCollegeBothWays) {
  const Truth most = parse_truth_table(
      "#sec,nsec,x,y,z,qx,qy,qz,qw\n1583836591,182590976,5.5,-1,0.25,0,0,0.6,0.8\n");
  const Truth mound = parse_truth_table("1583836591.182590976 5.5 -1 0.25 0 0 0.6 0.8\n");
  ASSERT_EQ(most.poses.size(), 1U);
  EXPECT_EQ(most.poses[0].stamp_ns, mound.poses[0].stamp_ns);
  EXPECT_EQ(most.poses[0].pose.translation, mound.poses[0].pose.translation);
  EXPECT_NEAR(most.poses[0].pose.rotation.angularDistance(mound.poses[0].pose.rotation), 0, 1e-12);
}

TEST(TruthTable, MulRansNanosecondsAndMatrix) {
  const Truth truth = parse_truth_table("1561000444390857630,1,0,0,3,0,1,0,4,0,0,1,5\n");
  ASSERT_EQ(truth.poses.size(), 1U);
  EXPECT_EQ(truth.poses[0].stamp_ns, 1561000444390857630);
  EXPECT_EQ(truth.poses[0].pose.translation, Eigen::Vector3d(3, 4, 5));
}

TEST(TruthTable, WholeMicrosecondsAndMilliseconds) {
  const Truth micro = parse_truth_table("1561000444390857 1 2 3\n1561000444490857 1 2 3\n");
  EXPECT_EQ(micro.poses[1].stamp_ns, 1561000444490857000);
  EXPECT_EQ(micro.what, "4 columns, times in microseconds, positions without rotations");
  const Truth milli =
      parse_truth_table("1561000444390 1 2 3 0 0 0 1\n1561000444490 1 2 3 0 0 1 0\n");
  EXPECT_EQ(milli.poses[1].stamp_ns, 1561000444490000000);
  EXPECT_EQ(milli.what, "8 columns, times in milliseconds");
  const Truth uptime = parse_truth_table("5000000000 1 2 3\n1561000444490 1 2 3\n");
  EXPECT_EQ(uptime.poses[0].stamp_ns, 5000000000);
  EXPECT_EQ(uptime.poses[1].stamp_ns, 1561000444490);
}

TEST(TruthTable, PositionsWithoutAttitude) {
  const Truth m2dgr = parse_truth_table("1.5 1 2 3 0 0 0 0\n1.6 1 2 3 0 0 0 0\n");
  EXPECT_FALSE(m2dgr.has_rotations);
  const Truth prism = parse_truth_table("1.5 1 2 3\n");
  EXPECT_FALSE(prism.has_rotations);
  EXPECT_EQ(prism.poses[0].pose.translation, Eigen::Vector3d(1, 2, 3));
}

TEST(TruthTable, NamesTellWhetherWIsFirst) {
  const auto w_of = [](const std::string& text) {
    return parse_truth_table(text).poses.at(0).pose.rotation.w();
  };
  const std::string row = "1403636579758555392,4.6,-1.7,0.6,1,0,0,0\n";
  const std::string euroc =
      "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
      "q_RS_z []\n" +
      row;
  EXPECT_EQ(w_of(euroc), 1.0);
  EXPECT_EQ(parse_truth_table(euroc).what, "8 columns, rotations as w x y z");
  EXPECT_EQ(w_of("t,x,y,z,qw,qx,qy,qz\n" + row), 1.0);
  EXPECT_EQ(w_of("sec,nsec,x,y,z,qw,qx,qy,qz\n1583836591,182590976,5.5,-1,0.2,1,0,0,0\n"), 1.0);
  EXPECT_EQ(w_of("t,x,y,z,qx,qy,qz,qw\n" + row), 0.0);
  EXPECT_EQ(w_of("t,p_x,p_y,p_z,orientation.w,orientation.x,orientation.y,orientation.z\n" + row),
            1.0);
  EXPECT_EQ(w_of("# a raw view, w unknown\n" + row), 0.0);
  EXPECT_EQ(w_of("timestamp,x_w,y_w,z_w,qx,qy,qz,qw\n" + row), 0.0);
  EXPECT_EQ(w_of("# T_w p_x p_y p_z q_x q_y q_z q_w\n" + row), 0.0);
  EXPECT_EQ(w_of("# poses in frame_w, axes frame_x frame_y frame_z\n" + row), 0.0);
  EXPECT_EQ(parse_truth_table(row).what, "8 columns, rotations taken as x y z w");
}

// As FusionPortable's of a total station.
TEST(TruthTable, RotationsThatNeverTurnAreAskedAbout) {
  const Truth station = parse_truth_table("1.5 1 2 3 0 0 0 1\n1.6 4 2 3 0 0 0 1\n");
  EXPECT_TRUE(station.has_rotations);
  EXPECT_NE(station.what.find("no rotation in any row"), std::string::npos) << station.what;
  const Truth other = parse_truth_table("1.5 1 2 3 0 0 0 1\n1.6 4 2 3 0 0 1 0\n");
  EXPECT_EQ(other.what, "8 columns");
}

TEST(TruthTable, WhatFitsNothingIsRefusedByLine) {
  const auto error = [](const char* text) -> std::string {
    try {
      (void)parse_truth_table(text);
    } catch (const ReadError& what) {
      return what.what();
    }
    return "taken";
  };
  EXPECT_NE(error("1 2 3 4 5\n").find("line 1: 5 columns"), std::string::npos);
  EXPECT_NE(error("1 1 2 3 0 0 0 1\n2 1 2\n").find("line 2: 3 columns"), std::string::npos);
  EXPECT_NE(error("1 1 2 3 0 0 0 5\n").find("quaternion"), std::string::npos);
  EXPECT_NE(error("1.5 7 1 2 3 0 0 0 1\n").find("seconds and nanoseconds"), std::string::npos);
  EXPECT_NE(error("1 nan 2 3 0 0 0 1\n").find("finite"), std::string::npos);
  EXPECT_NE(error("# nothing\n").find("no poses"), std::string::npos);
}

// The camera's frame: z forward, x right. Its calibration lies beside the poses.
TEST(Truth, KittisPosesAreOfTheCamera) {
  const test::TemporaryFolder scratch;
  scratch.write("00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 2\n");
  scratch.write("calib.txt",
                "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 0 -1 0 0.1 0 0 -1 -0.2 1 0 0 -0.3\n");
  scratch.write("times.txt", "0\n0.1037\n");
  const Truth truth = read_truth(scratch.path() / "00.txt", &dataset_named("kitti"));
  ASSERT_EQ(truth.poses.size(), 2U);
  EXPECT_TRUE(truth.has_stamps);
  EXPECT_EQ(truth.poses[1].stamp_ns, 103'700'000);
  // The LiDAR's forward is the camera's z.
  const Pose T_lidar_camera = truth.T_lidar_truth;
  EXPECT_LT((T_lidar_camera.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(),
            1e-12);
  EXPECT_LT((T_lidar_camera.translation - Eigen::Vector3d(0.3, 0.1, -0.2)).norm(), 1e-12);
}

TEST(Truth, KittiWithoutItsCalibrationSaysWhatIsMissing) {
  const test::TemporaryFolder scratch;
  scratch.write("00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  try {
    (void)read_truth(scratch.path() / "00.txt", &dataset_named("kitti"));
    ADD_FAILURE() << "taken";
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find("calib.txt"), std::string::npos);
  }
}

TEST(Truth, KittiRawsRecordsBecomePoses) {
  const test::TemporaryFolder scratch;
  fs::create_directories(scratch.path() / "oxts" / "data");
  // About one metre north, turned by a quarter to the left.
  scratch.write("oxts/data/0000000000.txt", "49.0 8.0 110 0 0 0 9 9\n");
  scratch.write("oxts/data/0000000001.txt", "49.0000089932 8.0 110.5 0 0 1.5707963267948966 9 9\n");
  scratch.write("oxts/timestamps.txt", "2011-09-26 13:02:25.5\n2011-09-26 13:02:25.6\n");
  scratch.write("calib_imu_to_velo.txt", "calib_time: x\nR: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n");
  const Truth truth = read_truth(scratch.path(), &dataset_named("kitti-raw"));
  ASSERT_EQ(truth.poses.size(), 2U);
  const Pose& moved = truth.poses[1].pose;
  EXPECT_NEAR(moved.translation.x(), 0.0, 1e-6);
  EXPECT_NEAR(moved.translation.y(), 1.0, 0.01);
  EXPECT_NEAR(moved.translation.z(), 0.5, 1e-9);
  EXPECT_NEAR(moved.rotation.angularDistance(Eigen::Quaterniond::Identity()), std::numbers::pi / 2,
              1e-9);
  EXPECT_EQ(truth.T_lidar_truth.translation, Eigen::Vector3d(-0.8, 0.3, -0.8));
}

TEST(Truth, ThirteenColumnsThatAreNoMatrixAreToldSo) {
  const std::string boreas = "1048955000,-14.7,-29.9,0.4,0,0,0,-0.006,-0.01,-0.03,0,0,0\n";
  const std::string error = test::message_of<ReadError>([&] { (void)parse_truth_table(boreas); });
  EXPECT_NE(error.find("rows of a 3x4 matrix (MulRan's)"), std::string::npos) << error;
}

TEST(Datasets, EachHasAllThatAUserMustKnow) {
  for (const Dataset& set : datasets()) {
    EXPECT_FALSE(set.what.empty()) << set.name;
    EXPECT_FALSE(set.truth_file.empty()) << set.name;
    EXPECT_FALSE(set.tried.empty()) << set.name;
  }
  for (const char* name : {"kitti", "kitti-raw", "newer-college", "hilti-2022", "mulran", "s3e",
                           "leg-kilo", "quadruped-slam", "grandtour", "diter",
                           "fusionportable-legged", "m2dgr", "ntu-viral", "botanic-garden"}) {
    EXPECT_EQ(dataset_named(name).name, name);
  }
  EXPECT_THROW((void)dataset_named("nowhere"), ReadError);
}

TEST(Datasets, SayWhatTheOptionsLeaveOpenAndNoMore) {
  OpenOptions options;
  options.dataset = "leg-kilo";
  EXPECT_EQ(with_dataset(options).stamp_at, StampAt::end);
  EXPECT_EQ(with_dataset(options).likely_topics.front(), "/points_raw");
  options.stamp_at = StampAt::start;
  options.topic = "/other";
  EXPECT_EQ(with_dataset(options).stamp_at, StampAt::start);
  EXPECT_TRUE(with_dataset(options).likely_topics.empty());
}

TEST(Datasets, FusionPortablesTotalStationKnowsNoRotations) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("gt.txt", "1.5 1 2 3 0 0 0 1\n1.6 4 2 3 0 0 0 1\n");
  EXPECT_FALSE(read_truth(file, &dataset_named("fusionportable-legged")).has_rotations);
}

TEST(Datasets, TheViralPrismHangsBelowTheLidar) {
  const Dataset& set = dataset_named("ntu-viral");
  ASSERT_TRUE(set.T_lidar_truth);
  EXPECT_LT(
      (set.T_lidar_truth->translation - Eigen::Vector3d(-0.243656, -0.012288, -0.328095)).norm(),
      1e-12);
}

}  // namespace
}  // namespace surefoot::io
