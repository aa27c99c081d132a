// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Pose algebra against 4 x 4 matrices; roll, pitch and yaw.
#include "surefoot/pose.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

TEST(Pose, ActsComposesAndInvertsLikeItsMatrix) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Pose a = random.pose(10.0, std::numbers::pi), b = random.pose(10.0, std::numbers::pi);
    const Eigen::Vector3d p = random.vector(10.0);
    EXPECT_LT((a * p - (a.matrix() * p.homogeneous()).head<3>()).norm(), 1e-13);
    EXPECT_LT(((a * b).matrix() - a.matrix() * b.matrix()).norm(), 1e-13);
    EXPECT_LT((a.inverse().matrix() - a.matrix().inverse()).norm(), 1e-13);
    EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-13);
    EXPECT_LT(((a * b).inverse().matrix() - (b.inverse() * a.inverse()).matrix()).norm(), 1e-13);
  }
}

TEST(Pose, DefaultIsIdentity) {
  EXPECT_EQ(Pose{}.matrix(), Eigen::Matrix4d::Identity());
  const Eigen::Vector3d p(1.0, 2.0, 3.0);
  EXPECT_EQ(Pose{} * p, p);
}

TEST(Pose, StaysRigidOverAHundredThousandProducts) {
  Random random(2);
  const Pose step = {so3_exp(0.01 * random.unit_vector()), {0.01, 0.0, 0.0}};
  Pose pose;
  for (int i = 0; i < 100'000; ++i) pose = pose * step;
  EXPECT_NEAR(pose.rotation.norm(), 1.0, 1e-15);
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  // Powers of one rotation share its axis: the angle is 1e5 steps, modulo a turn.
  const double angle = std::remainder(1e5 * 0.01, 2.0 * std::numbers::pi);
  EXPECT_NEAR(so3_log(pose.rotation).norm(), std::abs(angle), 1e-9);
}

TEST(Pose, RollPitchYawAreTheAnglesOfThreeTurns) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d angles(random.uniform(-std::numbers::pi, std::numbers::pi),
                                 random.uniform(-1.57, 1.57),
                                 random.uniform(-std::numbers::pi, std::numbers::pi));
    const Eigen::Quaterniond turns = so3_exp({0.0, 0.0, angles.z()}) *
                                     so3_exp({0.0, angles.y(), 0.0}) *
                                     so3_exp({angles.x(), 0.0, 0.0});
    EXPECT_LT((turns.coeffs() - from_roll_pitch_yaw(angles).coeffs()).norm(), 1e-15);
    // Near the pole, at a pitch of 1.57, angles lose digits as 1 / cos(pitch) = 1256.
    EXPECT_LT((roll_pitch_yaw(turns) - angles).norm(), 1e-9);
  }
}

TEST(Pose, RollPitchYawAtThePoleStillGiveTheSameRotation) {
  Random random(4);
  for (const double pitch : {0.5 * std::numbers::pi, -0.5 * std::numbers::pi}) {
    for (int i = 0; i < 200; ++i) {
      const double roll = random.uniform(-std::numbers::pi, std::numbers::pi),
                   yaw = random.uniform(-std::numbers::pi, std::numbers::pi);
      // At the pole and next to it, on both sides of where roll is no longer told from yaw.
      for (const double beside : {0.0, 1e-9, 9e-8, 2e-7, 1e-5}) {
        const double off = pitch > 0.0 ? -beside : beside;
        const Eigen::Quaterniond rotation = from_roll_pitch_yaw({roll, pitch + off, yaw});
        const Eigen::Vector3d angles = roll_pitch_yaw(rotation);
        ASSERT_TRUE(angles.allFinite());
        EXPECT_NEAR(angles.y(), pitch, 2e-5);
        // Roll and yaw turn about one axis there: only their sum or difference is known.
        EXPECT_LT(rotation.angularDistance(from_roll_pitch_yaw(angles)), 1e-6) << beside;
      }
    }
  }
}

}  // namespace
}  // namespace surefoot
