// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The motion prior: the last velocity carried on, over gaps too.
#include "methods/paper/prediction.hpp"

#include <gtest/gtest.h>

#include "support/matrix_exponential.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

LastMotion random_motion(std::uint64_t seed) {
  test::Random random(seed);
  return {{500 * kMillisecond, random.pose(20.0, 3.0)}, random.twist(2.0, 1.0)};
}

TEST(MotionPrior, StartAndEndLieOnTheLastVelocity) {
  const LastMotion motion = random_motion(1);
  const MotionPrior prior = predict_motion(motion, 550 * kMillisecond, 650 * kMillisecond, 0.5);
  const Eigen::Matrix4d last = motion.last.pose.matrix();
  const Eigen::Matrix4d start = last * test::matrix_exponential(0.05 * motion.velocity);
  const Eigen::Matrix4d end = last * test::matrix_exponential(0.15 * motion.velocity);
  EXPECT_LT((prior.T_start.matrix() - start).norm(), 1e-12);
  EXPECT_LT((prior.T_end.matrix() - end).norm(), 1e-12);
}

TEST(MotionPrior, AScanMayStartBeforeTheLastPose) {
  const LastMotion motion = random_motion(2);
  const MotionPrior prior = predict_motion(motion, 480 * kMillisecond, 580 * kMillisecond, 0.5);
  const Eigen::Matrix4d start =
      motion.last.pose.matrix() * test::matrix_exponential(-0.02 * motion.velocity);
  EXPECT_LT((prior.T_start.matrix() - start).norm(), 1e-12);
}

TEST(MotionPrior, BeyondTheLongestGapThePredictionStandsStill) {
  const LastMotion motion = random_motion(3);
  for (const std::int64_t gap_ms : {301, 1000, 1'000'000'000}) {
    const std::int64_t start_ns = (500 + gap_ms) * kMillisecond;
    const MotionPrior prior = predict_motion(motion, start_ns, start_ns + 100 * kMillisecond, 0.3);
    const Eigen::Matrix4d start =
        motion.last.pose.matrix() * test::matrix_exponential(0.3 * motion.velocity);
    EXPECT_LT((prior.T_start.matrix() - start).norm(), 1e-12);
    // The scan's own motion is predicted all the same.
    const Eigen::Matrix4d end = start * test::matrix_exponential(0.1 * motion.velocity);
    EXPECT_LT((prior.T_end.matrix() - end).norm(), 1e-12);
  }
}

TEST(MotionPrior, NextVelocityReproducesTheStep) {
  test::Random random(4);
  const LastMotion motion = random_motion(5);
  for (const std::int64_t step_ms : {20, 100, 5000}) {
    const StampedPose pose = {(500 + step_ms) * kMillisecond, random.pose(20.0, 3.0)};
    const LastMotion next = next_motion(motion, pose);
    EXPECT_EQ(next.last.stamp_ns, pose.stamp_ns);
    const Pose again =
        motion.last.pose * se3_exp(1e-3 * static_cast<double>(step_ms) * next.velocity);
    EXPECT_LT((again.matrix() - pose.pose.matrix()).norm(), 1e-11);
  }
}

TEST(MotionPrior, TwoPosesOfOneInstantTellOfNoVelocity) {
  test::Random random(4);
  const LastMotion motion = random_motion(5);
  for (const std::int64_t step_ms : {0, 1, 9}) {
    const StampedPose pose = {(500 + step_ms) * kMillisecond, random.pose(20.0, 3.0)};
    const LastMotion next = next_motion(motion, pose);
    EXPECT_EQ(next.last.stamp_ns, pose.stamp_ns);
    EXPECT_EQ(next.velocity, motion.velocity);
  }
}

TEST(MotionPrior, AtRestNothingIsPredicted) {
  LastMotion motion = random_motion(6);
  motion.velocity.setZero();
  const MotionPrior prior = predict_motion(motion, 550 * kMillisecond, 650 * kMillisecond, 0.5);
  EXPECT_LT((prior.T_end.matrix() - motion.last.pose.matrix()).norm(), 1e-14);
}

}  // namespace
}  // namespace surefoot
