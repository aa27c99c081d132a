// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The motion that a scan is deskewed by, eqs. (5)-(9), against Eigen's matrix functions, angle-axis
// interpolation and static scenes seen by a moving sensor.
#include "methods/paper/prediction.hpp"

#include <gtest/gtest.h>

#include "core/deskew.hpp"
#include "support/default_parameters.hpp"
#include "support/matrix_exponential.hpp"
#include "support/random.hpp"
#include "support/static_scene.hpp"

namespace surefoot {
namespace {

using test::kEnd;
using test::kFloatRounding;
using test::kStart;
using test::largest_miss;
using test::measure;
using test::Random;
using test::random_scene;

PaperParameters::Deskew paper_config(int segments) {
  PaperParameters::Deskew config = test::default_parameters<PaperParameters>().deskew;
  config.mode = DeskewMode::piecewise;
  config.segments = segments;
  config.clamp_z = 0.5;
  config.clamp_roll = 0.2;
  config.clamp_pitch = 0.2;
  return config;
}

/// Limits that no motion in these tests reaches.
PaperParameters::Deskew loose_config(int segments) {
  PaperParameters::Deskew config = paper_config(segments);
  config.clamp_z = config.clamp_roll = config.clamp_pitch = 3.0;
  return config;
}

MotionPrior prior_of(const Pose& T_start, const Twist& twist) {
  return {T_start, T_start * se3_exp(twist)};
}

double difference(const Pose& a, const Eigen::Matrix4d& b) { return (a.matrix() - b).norm(); }

TEST(Prediction, ClampLimitsExactlyZRollAndPitch) {
  const PaperParameters::Deskew config = paper_config(4);
  for (const double sign : {-1.0, 1.0}) {
    const Twist beyond = sign * (Twist() << 9.0, 8.0, 7.0, 1.0, 1.1, 1.2).finished();
    const Twist expected = sign * (Twist() << 9.0, 8.0, 0.5, 0.2, 0.2, 1.2).finished();
    EXPECT_EQ(clamp_twist(beyond, config), expected);
    const Twist within = sign * (Twist() << 9.0, 8.0, 0.49, 0.19, 0.2, 1.2).finished();
    EXPECT_EQ(clamp_twist(within, config), within);
  }
}

TEST(Prediction, ClampTakesEachLimitFromItsOwnParameter) {
  PaperParameters::Deskew config = paper_config(4);
  config.clamp_z = 0.1;
  config.clamp_roll = 0.2;
  config.clamp_pitch = 0.3;
  const Twist expected = (Twist() << 1.0, 1.0, 0.1, 0.2, 0.3, 1.0).finished();
  EXPECT_EQ(clamp_twist(Twist::Ones(), config), expected);
}

TEST(Prediction, RelativeMotionAndReconstructionGiveBackAnUnclampedEnd) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const MotionPrior prior = prior_of(random.pose(50.0, 3.0), random.twist(2.0, 0.5));
    const ScanTrajectory trajectory = predict_trajectory(prior, kStart, kEnd, loose_config(4));
    EXPECT_LT(difference(trajectory.boundary(0), prior.T_start.matrix()), 1e-13);
    EXPECT_LT(difference(trajectory.boundary(4), prior.T_end.matrix()), 1e-12);
  }
}

TEST(Prediction, CorrectedEndIsTheExponentialOfTheClampedLogarithm) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const MotionPrior prior = prior_of(random.pose(50.0, 3.0), random.twist(2.0, 0.8));
    const Eigen::Matrix4d relative = prior.T_start.matrix().inverse() * prior.T_end.matrix();
    Twist xi = test::matrix_logarithm(relative);
    xi[2] = std::min(std::max(xi[2], -0.5), 0.5);
    xi[3] = std::min(std::max(xi[3], -0.2), 0.2);
    xi[4] = std::min(std::max(xi[4], -0.2), 0.2);
    const Eigen::Matrix4d expected = prior.T_start.matrix() * test::matrix_exponential(xi);
    const ScanTrajectory trajectory = predict_trajectory(prior, kStart, kEnd, paper_config(4));
    EXPECT_LT(difference(trajectory.boundary(4), expected), 1e-8);
  }
}

TEST(Prediction, BoundariesTurnEvenlyAndMoveAlongTheChord) {
  Random random(3);
  for (const int K : {1, 2, 4, 7}) {
    const MotionPrior prior = prior_of(random.pose(10.0, 3.0), random.twist(2.0, 0.8));
    const ScanTrajectory trajectory = predict_trajectory(prior, kStart, kEnd, loose_config(K));
    ASSERT_EQ(trajectory.segments(), static_cast<std::size_t>(K));
    const Eigen::AngleAxisd turn(prior.T_start.rotation.conjugate() * prior.T_end.rotation);
    for (int k = 0; k <= K; ++k) {
      const double u = static_cast<double>(k) / K;
      const Pose& T_k = trajectory.boundary(static_cast<std::size_t>(k));
      const Eigen::Quaterniond rotation =
          prior.T_start.rotation * Eigen::AngleAxisd(u * turn.angle(), turn.axis());
      const Eigen::Vector3d translation =
          (1.0 - u) * prior.T_start.translation + u * prior.T_end.translation;
      EXPECT_LT((T_k.rotation.toRotationMatrix() - rotation.toRotationMatrix()).norm(), 1e-12);
      EXPECT_LT((T_k.translation - translation).norm(), 1e-12);
    }
  }
}

TEST(Prediction, InterpolationMeetsItsEndsAndTakesTheShorterWay) {
  const Pose a{so3_exp({0.0, 0.0, 0.1}), {1.0, 0.0, 0.0}};
  Pose b{so3_exp({0.0, 0.0, 0.5}), {2.0, 1.0, 0.0}};
  b.rotation.coeffs() = -b.rotation.coeffs();  // the same rotation
  EXPECT_LT(difference(interpolate(a, b, 0.0), a.matrix()), 1e-15);
  EXPECT_LT(difference(interpolate(a, b, 1.0), b.matrix()), 1e-15);
  EXPECT_NEAR(so3_log(interpolate(a, b, 0.5).rotation).z(), 0.3, 1e-15);
}

TEST(Prediction, OtherModesPredictThePriorsOneTwistUnclamped) {
  const MotionPrior prior = prior_of(Pose{}, (Twist() << 1, 0, 2.0, 0.6, 0.7, 0.1).finished());
  for (const DeskewMode mode : {DeskewMode::none, DeskewMode::constant_velocity}) {
    PaperParameters::Deskew config = paper_config(4);
    config.mode = mode;
    const ScanTrajectory trajectory = predict_trajectory(prior, kStart, kEnd, config);
    EXPECT_EQ(trajectory.segments(), 1U);
    EXPECT_LT(difference(trajectory.at(1.0), prior.T_end.matrix()), 1e-13);
  }
}

TEST(Prediction, PiecewiseRestoresAStaticSceneUnderConstantVelocityOrRotation) {
  Random random(5);
  const Pose T_start = random.pose(5.0, 1.0);
  for (const bool turning : {false, true}) {
    // With rotation alone or translation alone, slerp and lerp are the constant twist itself.
    Twist twist = Twist::Zero();
    if (turning) twist.tail<3>() << 0.05, -0.1, 0.3;
    if (!turning) twist.head<3>() << 0.2, 0.05, -0.1;
    const auto motion = [&](double tau) { return T_start * se3_exp(tau * twist); };
    const auto scene = random_scene(random, T_start, 2000);
    const PaperParameters::Deskew config = paper_config(4);
    const ScanTrajectory trajectory =
        predict_trajectory(prior_of(T_start, twist), kStart, kEnd, config);
    const auto deskewed = deskew(measure(scene, motion), trajectory, Workers(1));
    EXPECT_LT(largest_miss(deskewed, motion(0.5), scene), kFloatRounding);
  }
}

TEST(Prediction, PiecewiseOnAScrewMotionIsOffByTheChordsSagittaAtMost) {
  Random random(6);
  const Pose T_start = random.pose(5.0, 1.0);
  const Twist twist = (Twist() << 0.3, 0.0, 0.0, 0.0, 0.0, 0.2).finished();
  const auto motion = [&](double tau) { return T_start * se3_exp(tau * twist); };
  const auto scene = random_scene(random, T_start, 2000);
  const ScanTrajectory trajectory =
      predict_trajectory(prior_of(T_start, twist), kStart, kEnd, paper_config(4));
  const auto deskewed = deskew(measure(scene, motion), trajectory, Workers(1));
  // An arc of 0.3 m that turns by 0.2 rad bulges from its chord by l * a / 8 = 7.5 mm; both the
  // point's instant and mid-scan may be off by that.
  const double miss = largest_miss(deskewed, motion(0.5), scene);
  EXPECT_LT(miss, 2.0 * 0.3 * 0.2 / 8.0);
  EXPECT_GT(miss, 1e-3);
}

}  // namespace
}  // namespace surefoot
