// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

constexpr std::int64_t kStep = 100'000'000;  // [ns]

/// A straight walk along x that looks ahead, moved by `T`.
Trajectory walk(const Pose& T, std::size_t poses, std::int64_t start_ns = 0) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses; ++i) {
    Pose pose;
    pose.translation.x() = 0.1 * double(i);
    trajectory.push_back({start_ns + std::int64_t(i) * kStep, T * pose});
  }
  return trajectory;
}

Pose turned() {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(std::numbers::pi / 3, Eigen::Vector3d::UnitX());
  pose.translation = {100, -3, 7};
  return pose;
}

TEST(RunTruth, IsLaidIntoTheMapByPosesAlsoOnAStraightWay) {
  const Trajectory measured = walk({}, 50);
  const Trajectory truth = walk(turned(), 80);
  const Trajectory shown = truth_in_map(truth, measured);
  ASSERT_EQ(shown.size(), 50U);  // from the run's first to its last pose
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(shown[i].stamp_ns, measured[i].stamp_ns);
    EXPECT_LT((shown[i].pose.translation - measured[i].pose.translation).norm(), 1e-9);
    EXPECT_LT(shown[i].pose.rotation.angularDistance(measured[i].pose.rotation), 1e-9);
  }
}

/// The run bends upwards, which loops mended: laid on the run, the truth would lie askew.
TEST(RunTruth, IsLaidOnTheWayAfterLoopsWhereSomeWereTaken) {
  Trajectory bent = walk({}, 50);
  for (StampedPose& pose : bent) {
    const double x = pose.pose.translation.x();
    pose.pose.translation.z() = 0.1 * x * x;
  }
  report::DrawnLoops loops;
  loops.corrected = walk({}, 50);
  const Trajectory truth = walk(turned(), 50);
  const auto farthest = [&] {
    double most = 0.0;
    const Trajectory shown = truth_in_map(truth, bent, loops);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const Eigen::Vector3d& place = loops.corrected[i].pose.translation;
      most = std::max(most, (shown[i].pose.translation - place).norm());
    }
    return most;
  };
  EXPECT_GT(farthest(), 0.1) << "no loop was taken";
  loops.taken = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  EXPECT_LT(farthest(), 1e-9);
}

TEST(RunTruth, OfAnotherTimeIsNone) {
  EXPECT_TRUE(truth_in_map(walk(turned(), 50, 1'000'000'000'000), walk({}, 50)).empty());
  EXPECT_TRUE(truth_in_map({}, walk({}, 50)).empty());
  EXPECT_TRUE(truth_in_map(walk({}, 50), {}).empty());
}

/// As a truth of 100 Hz between whose stamps a scan's lies, or of 10 Hz: 50 ms off each.
TEST(RunTruth, IsInterpolatedAtTheStampsOfTheRun) {
  const Trajectory truth = walk(turned(), 80, -kStep / 2);
  const Trajectory measured = walk({}, 50);
  EXPECT_EQ(pairing_with(truth, measured).method, evaluation::AssociationMethod::interpolate);
  const Trajectory shown = truth_in_map(truth, measured);
  ASSERT_EQ(shown.size(), 49U);
  EXPECT_NEAR(shown[0].pose.translation.x(), 0.05, 1e-9);
}

TEST(RunTruth, OfPosesFarApartIsPairedByTheNearestStamp) {
  const Trajectory all = walk(turned(), 50);
  const Trajectory truth = {all[0], all[20], all[40]};
  EXPECT_EQ(pairing_with(truth, walk({}, 50)).method, evaluation::AssociationMethod::interpolate)
      << "exact stamps need no interpolation";
  Trajectory late = truth;
  for (StampedPose& pose : late) pose.stamp_ns += 1'000'000;
  EXPECT_EQ(pairing_with(late, walk({}, 50)).method, evaluation::AssociationMethod::nearest);
  late.front().stamp_ns = truth.front().stamp_ns;  // one exact stamp is not the most of them
  EXPECT_EQ(pairing_with(late, walk({}, 50)).method, evaluation::AssociationMethod::nearest);
}

TEST(RunTruth, OfOtherTimesIsToldWithBoth) {
  const Trajectory truth = walk({}, 11, 5'000'000'000);
  EXPECT_EQ(other_times("gt.tum", truth, 0, 4'999'999'999),
            "gt.tum: tells of 5.000000000 to 6.000000000 s, and the scans are of 0.000000000 to "
            "4.999999999 s: they have no time in common, so nothing is compared");
  EXPECT_NE(other_times("gt.tum", truth, 6'000'000'001, 7'000'000'000), "");
  EXPECT_EQ(other_times("gt.tum", truth, 0, 5'000'000'000), "");
  EXPECT_EQ(other_times("gt.tum", {}, 0, 1), "gt.tum: holds no poses");
}

TEST(RunTruth, OutOfOrderIsNone) {
  Trajectory truth = walk({}, 50);
  std::swap(truth[3], truth[30]);
  EXPECT_TRUE(truth_in_map(truth, walk({}, 50)).empty());
}

class TruthBeside : public test::Scratch {};

TEST_F(TruthBeside, LiesInTheFolderBesideTheFileOrBesideTheBag) {
  const std::filesystem::path truth = write("walk/gt.tum", "");
  (void)write("walk/walk.mcap", "");
  (void)write("walk/bag/metadata.yaml", "");
  (void)write("walk/bag/bag_0.db3", "");
  (void)write("walk/other/000000.pcd", "");
  for (const char* input :
       {"walk", "walk/walk.mcap", "walk/bag", "walk/bag/", "walk/bag/bag_0.db3"}) {
    std::error_code ignored;
    EXPECT_TRUE(std::filesystem::equivalent(truth_beside(folder_ / input), truth, ignored))
        << input;
  }
  EXPECT_EQ(truth_beside(folder_ / "walk/other"), "") << "no bag";
  EXPECT_EQ(truth_beside(folder_ / "walk/of_a_topic"), "") << "no file";
  EXPECT_EQ(truth_beside(""), "");
}

}  // namespace
}  // namespace surefoot::runs
