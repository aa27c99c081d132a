// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Rigid motions: exp and log of twists against Eigen's general matrix functions.
#include <gtest/gtest.h>

#include <numbers>

#include "geometry/se3.hpp"
#include "support/matrix_exponential.hpp"
#include "support/random.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {
namespace {

using test::Random;

Twist twist_of_angle(Random& random, double angle, double translation) {
  Twist twist;
  twist.head<3>() = random.vector(translation);
  twist.tail<3>() = angle * random.unit_vector();
  return twist;
}

TEST(Se3, ExponentialAgreesWithTheMatrixExponential) {
  Random random(1);
  for (const double angle : {0.0, 1e-12, 1e-8, 1e-4, 0.99e-2, 1.01e-2, 0.5, 2.0,
                             std::numbers::pi - 1e-8, std::numbers::pi}) {
    for (int i = 0; i < 20; ++i) {
      const Twist twist = twist_of_angle(random, angle, 3.0);
      EXPECT_LT((se3_exp(twist).matrix() - test::matrix_exponential(twist)).norm(), 3e-14)
          << "angle " << angle;
    }
  }
}

TEST(Se3, ATurnIsAsLargeAsItsAxisAngle) {
  Random random(5);
  for (const double angle : {0.0, 1e-9, 0.3, 2.0, std::numbers::pi - 1e-6}) {
    Pose motion = se3_exp(twist_of_angle(random, angle, 3.0));
    EXPECT_NEAR(turn_angle(motion), angle, 1e-12);
    motion.rotation.coeffs() *= -1.0;  // the same
    EXPECT_NEAR(turn_angle(motion), angle, 1e-12);
  }
}

TEST(Se3, LogarithmAgreesWithTheMatrixLogarithm) {
  Random random(2);
  for (const double angle : {1e-6, 1e-3, 0.1, 1.0, 2.0, 3.0}) {
    for (int i = 0; i < 20; ++i) {
      const Pose pose = {so3_exp(angle * random.unit_vector()), random.vector(3.0)};
      EXPECT_LT((se3_log(pose) - test::matrix_logarithm(pose.matrix())).norm(), 1e-9)
          << "angle " << angle;
    }
  }
}

TEST(Se3, RoundTripFromTwists) {
  Random random(3);
  for (const double angle : {0.0, 1e-200, 1e-8, 1e-4, 1e-2, 1.0, 3.0, std::numbers::pi - 1e-4,
                             std::numbers::pi - 1e-8}) {
    for (int i = 0; i < 20; ++i) {
      const Twist twist = twist_of_angle(random, angle, 10.0);
      EXPECT_LT((se3_log(se3_exp(twist)) - twist).norm(), 1e-13) << "angle " << angle;
    }
  }
}

TEST(Se3, RoundTripFromPosesIncludingHalfTurns) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    Pose pose = random.pose(20.0, std::numbers::pi);
    if (i % 5 == 0) pose.rotation = so3_exp(std::numbers::pi * random.unit_vector());
    const Pose back = se3_exp(se3_log(pose));
    EXPECT_LT((back.matrix() - pose.matrix()).norm(), 1e-13);
  }
}

TEST(Se3, TwistIsOrderedAsInEquation2) {
  // [x y z roll pitch yaw]: each entry alone moves or turns about its own axis.
  for (int axis = 0; axis < 3; ++axis) {
    Twist move = Twist::Zero();
    move[axis] = 0.3;
    const Pose moved = se3_exp(move);
    EXPECT_LT((moved.translation - 0.3 * Eigen::Vector3d::Unit(axis)).norm(), 1e-16);
    EXPECT_LT(so3_log(moved.rotation).norm(), 1e-16);

    Twist turn = Twist::Zero();
    turn[3 + axis] = 0.3;
    const Pose turned = se3_exp(turn);
    EXPECT_LT(turned.translation.norm(), 1e-16);
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();
    angles[axis] = 0.3;
    EXPECT_LT((roll_pitch_yaw(turned.rotation) - angles).norm(), 1e-15);
  }
}

TEST(Se3, ConstantTwistComposesOverTime) {
  Random random(5);
  const Twist twist = random.twist(2.0, 1.0);
  const Pose whole = se3_exp(twist);
  const Pose halves = se3_exp(0.5 * twist) * se3_exp(0.5 * twist);
  EXPECT_LT((whole.matrix() - halves.matrix()).norm(), 1e-14);
}

TEST(Se3, AFullTurnOnACircleComesBack) {
  Twist twist = Twist::Zero();
  twist[0] = 2.0 * std::numbers::pi * 5.0;  // circumference of a circle of 5 m
  twist[5] = 2.0 * std::numbers::pi;
  EXPECT_LT(se3_exp(twist).translation.norm(), 1e-13);
}

}  // namespace
}  // namespace surefoot
