// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Poses within a scan, eqs. (9)-(11): segment selection, boundaries, instants, continuation.
#include "surefoot/scan_trajectory.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "support/matrix_exponential.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

double difference(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

ScanTrajectory random_trajectory(Random& random, int segments) {
  std::vector<Pose> boundaries = {random.pose(10.0, 3.0)};
  for (int k = 0; k < segments; ++k) {
    boundaries.push_back(boundaries.back() * se3_exp(random.twist(0.3, 0.2)));
  }
  return ScanTrajectory(boundaries, 1000, 100'001'000);
}

TEST(ScanTrajectory, LocalTwistsAreTheLogarithmsBetweenBoundaries) {
  Random random(1);
  const ScanTrajectory trajectory = random_trajectory(random, 5);
  for (std::size_t k = 0; k < 5; ++k) {
    const Eigen::Matrix4d between =
        trajectory.boundary(k).matrix().inverse() * trajectory.boundary(k + 1).matrix();
    EXPECT_LT((trajectory.segment_twist(k) - test::matrix_logarithm(between)).norm(), 1e-9);
  }
}

TEST(ScanTrajectory, PassesThroughItsBoundariesFromBothSides) {
  Random random(2);
  for (const int K : {1, 2, 3, 4, 7}) {
    const ScanTrajectory trajectory = random_trajectory(random, K);
    for (int k = 0; k <= K; ++k) {
      const double tau = static_cast<double>(k) / K;
      const Pose& expected = trajectory.boundary(static_cast<std::size_t>(k));
      EXPECT_LT(difference(trajectory.at(tau), expected), 1e-12);
      EXPECT_LT(difference(trajectory.at(std::nextafter(tau, -1.0)), expected), 1e-12);
      EXPECT_LT(difference(trajectory.at(std::nextafter(tau, 2.0)), expected), 1e-12);
    }
  }
}

TEST(ScanTrajectory, WithinASegmentTheTwistIsConstant) {
  Random random(3);
  const ScanTrajectory trajectory = random_trajectory(random, 4);
  for (int i = 0; i < 200; ++i) {
    const int k = static_cast<int>(random.below(4));
    const double u = random.uniform(0.0, 1.0);
    const auto segment = static_cast<std::size_t>(k);
    const Eigen::Matrix4d expected =
        trajectory.boundary(segment).matrix() *
        test::matrix_exponential(u * trajectory.segment_twist(segment));
    EXPECT_LT((trajectory.at((k + u) / 4.0).matrix() - expected).norm(), 1e-12);
  }
}

TEST(ScanTrajectory, OutsideTheScanTheNearestSegmentGoesOn) {
  Random random(4);
  const ScanTrajectory trajectory = random_trajectory(random, 4);
  const Pose before = trajectory.boundary(0) * se3_exp(-1.0 * trajectory.segment_twist(0));
  const Pose after = trajectory.boundary(4) * se3_exp(trajectory.segment_twist(3));
  EXPECT_LT(difference(trajectory.at(-0.25), before), 1e-12);
  EXPECT_LT(difference(trajectory.at(1.25), after), 1e-12);
}

TEST(ScanTrajectory, InstantsMapToNormalisedTime) {
  Random random(5);
  const ScanTrajectory trajectory = random_trajectory(random, 4);
  EXPECT_EQ(trajectory.tau(1000), 0.0);
  EXPECT_EQ(trajectory.tau(100'001'000), 1.0);
  EXPECT_EQ(trajectory.tau(trajectory.mid_ns()), 0.5);
  EXPECT_EQ(trajectory.mid_ns(), 50'001'000);
  EXPECT_LT(difference(trajectory.at_time(25'001'000), trajectory.boundary(1)), 1e-12);
}

TEST(ScanTrajectory, HugeStampsLoseNothing) {
  constexpr std::int64_t kHuge = 9'000'000'000'000'000'000;
  const Pose end = se3_exp((Twist() << 1, 0, 0, 0, 0, 0).finished());
  const ScanTrajectory trajectory({Pose{}, end}, kHuge, kHuge + 100'000'000);
  EXPECT_EQ(trajectory.mid_ns(), kHuge + 50'000'000);
  EXPECT_NEAR(trajectory.at_time(kHuge + 25'000'000).translation.x(), 0.25, 1e-15);
}

TEST(ScanTrajectory, AtOneInstantItStandsStill) {
  Random random(6);
  const Pose pose = random.pose(10.0, 3.0);
  const ScanTrajectory trajectory(pose, 77);
  EXPECT_EQ(trajectory.tau(77), 0.5);
  EXPECT_EQ(trajectory.tau(1'000'000), 0.5);
  for (const double tau : {-1.0, 0.0, 0.5, 2.0}) {
    EXPECT_LT(difference(trajectory.at(tau), pose), 1e-15);
  }
}

TEST(ScanTrajectory, OfFewerThanTwoPosesThereIsNone) {
  for (const std::size_t few : {0, 1}) {
    EXPECT_THROW(ScanTrajectory(std::vector<Pose>(few), 0, 1), std::invalid_argument) << few;
  }
}

TEST(ScanTrajectory, SeenFromAnotherFrameEveryPoseMoves) {
  Random random(7);
  const ScanTrajectory trajectory = random_trajectory(random, 4);
  const Pose T_new_old = random.pose(100.0, 3.0);
  const ScanTrajectory moved = trajectory.moved(T_new_old);
  for (const double tau : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    EXPECT_LT(difference(moved.at(tau), T_new_old * trajectory.at(tau)), 1e-12);
  }
}

TEST(ScanTrajectory, DelayedItIsTheSameMotionLater) {
  Random random(8);
  const ScanTrajectory trajectory = random_trajectory(random, 4);
  const ScanTrajectory delayed = trajectory.delayed(-77);
  EXPECT_EQ(delayed.mid_ns(), trajectory.mid_ns() - 77);
  EXPECT_EQ(delayed.end_ns(), trajectory.end_ns() - 77);
  EXPECT_LT(difference(delayed.at(0.3), trajectory.at(0.3)), 1e-15);
}

}  // namespace
}  // namespace surefoot
