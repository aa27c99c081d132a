// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/trajectory_files.hpp"

#include <gtest/gtest.h>

#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

TEST(Tum, ExactText) {
  StampedPose pose;
  pose.stamp_ns = 1630577758569489956;
  pose.pose.translation = {1.5, -0.0000000001, 100.25};
  pose.pose.rotation = Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5);
  EXPECT_EQ(format_tum({pose}),
            "1630577758.569489956 1.500000000 0.000000000 100.250000000 0.500000000000 "
            "-0.500000000000 0.500000000000 0.500000000000\n");
}

TEST(Tum, ReadsCommentsAndAnyWhiteSpace) {
  const Trajectory trajectory =
      parse_tum("# t x y z\n\n1630577758.569489956 \t 1 2 3 0 0 0 1 \r\n  2e3 0 0 0 0 0 -2e-3 1");
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory[0].stamp_ns, 1630577758569489956);
  EXPECT_EQ(trajectory[0].pose.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(trajectory[1].stamp_ns, 2000'000'000'000);
  EXPECT_NEAR(trajectory[1].pose.rotation.norm(), 1.0, 1e-15);
}

TEST(Tum, ErrorsNameTheLine) {
  for (const char* bad : {"1 2 3", "1 0 0 0 0 0 0 1 9", "x 0 0 0 0 0 0 1", "1 0 0 nan 0 0 0 1",
                          "1 0 0 0 0 0 0 0", "1 0 0 0 0 0 0 1.1", "1 0 0 0 0 0 0 1x",
                          "1 0 0 inf 0 0 0 1", "1 0 0 0 1e200 1e200 0 1", "1e99 0 0 0 0 0 0 1"}) {
    const std::string message = test::message_of<ReadError>(
        [&] { (void)parse_tum(std::string("# first line\n") + bad + "\n"); });
    EXPECT_TRUE(message.starts_with("line 2: ")) << bad << " -> " << message;
  }
}

Trajectory random_trajectory() {
  Trajectory trajectory;
  std::srand(1);
  for (std::int64_t i = 0; i < 50; ++i) {
    StampedPose pose;
    pose.stamp_ns = 1'600'000'000'000'000'000 + i * 100'000'001;
    pose.pose.translation = 100.0 * Eigen::Vector3d::Random();
    pose.pose.rotation = so3_exp(3.0 * Eigen::Vector3d::Random());
    trajectory.push_back(pose);
  }
  return trajectory;
}

TEST(Tum, RoundTripThroughAFile) {
  const test::TemporaryFolder folder;
  const Trajectory trajectory = random_trajectory();
  write_tum(folder.path() / "t.tum", trajectory);
  const Trajectory back = read_tum(folder.path() / "t.tum");
  ASSERT_EQ(back.size(), trajectory.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].stamp_ns, trajectory[i].stamp_ns);
    EXPECT_LT((back[i].pose.translation - trajectory[i].pose.translation).norm(), 1e-9);
    EXPECT_LT(back[i].pose.rotation.angularDistance(trajectory[i].pose.rotation), 1e-11);
  }
  const std::string message =
      test::message_of<ReadError>([&] { (void)read_tum(folder.path() / "none.tum"); });
  EXPECT_NE(message.find("none.tum"), std::string::npos);
}

/// A file of more than one part that is read; its last line has no end.
TEST(Tum, ThinnedIsEveryPoseThatIsFarEnoughFromTheLastAndTheLast) {
  const test::TemporaryFolder folder;
  Trajectory fine;
  for (std::int64_t i = 0; i < 30'000; ++i) {
    fine.push_back({1'600'000'000'000'000'000 + i * 2'500'000, {}});
    fine.back().pose.translation.x() = 0.001 * static_cast<double>(i);
  }
  std::string text = format_tum(fine);
  ASSERT_GT(text.size(), std::size_t{2} << 20);
  text.pop_back();
  folder.write("fine.tum", text);
  const Trajectory thinned = read_tum_thinned(folder.path() / "fine.tum", 10'000'000);
  ASSERT_EQ(thinned.size(), 7'501U);
  for (std::size_t i = 0; i < 7'500; ++i) {
    ASSERT_EQ(thinned[i].stamp_ns, fine[4 * i].stamp_ns);
    ASSERT_NEAR(thinned[i].pose.translation.x(), fine[4 * i].pose.translation.x(), 1e-9);
  }
  EXPECT_EQ(thinned.back().stamp_ns, fine.back().stamp_ns);
  EXPECT_EQ(read_tum_thinned(folder.path() / "fine.tum", 1).size(), fine.size());

  folder.write("broken.tum", text + "\n1 2 3\n");
  const std::string message = test::message_of<ReadError>(
      [&] { (void)read_tum_thinned(folder.path() / "broken.tum", 10'000'000); });
  EXPECT_NE(message.find("broken.tum: line 30001"), std::string::npos) << message;
}

TEST(KittiPoses, RoundTripThroughAFile) {
  const test::TemporaryFolder folder;
  const Trajectory trajectory = random_trajectory();
  write_kitti_poses(folder.path() / "p.txt", trajectory);
  const std::vector<Pose> back = read_kitti_poses(folder.path() / "p.txt");
  ASSERT_EQ(back.size(), trajectory.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_LT((back[i].matrix() - trajectory[i].pose.matrix()).norm(), 3e-9);
  }
}

TEST(KittiPoses, RowMajorAndErrors) {
  const std::vector<Pose> poses = parse_kitti_poses("0 -1 0 4 1 0 0 5 0 0 1 6\n");
  EXPECT_LT((poses.at(0) * Eigen::Vector3d::UnitX() - Eigen::Vector3d(4, 6, 6)).norm(), 1e-12);
  for (const char* bad :
       {"1 0 0 0 0 1 0 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 -1 0", "2 0 0 0 0 2 0 0 0 0 2 0",
        "0 0 0 0 0 0 0 0 0 0 0 0", "1 0 0 0 0 1 0 0 0 0 1 x", "1e300 0 0 0 0 1 0 0 0 0 1 0"}) {
    const std::string message =
        test::message_of<ReadError>([&] { (void)parse_kitti_poses(std::string(bad) + "\n"); });
    EXPECT_TRUE(message.starts_with("line 1: ")) << bad << " -> " << message;
  }
}

TEST(EvoTrajectories, RealFilesRead) {
  const std::filesystem::path folder =
      std::filesystem::path(SUREFOOT_SHARED_DATA) / "evo_trajectories";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is absent";
  }
  EXPECT_EQ(read_kitti_poses(folder / "KITTI_00_gt.txt").size(), 4541U);
  EXPECT_GT(read_tum(folder / "fr2_desk_groundtruth.txt").size(), 10'000U);
}

}  // namespace
}  // namespace surefoot::io
