// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>

#include "evaluation/ape.hpp"
#include "evaluation/pose_error.hpp"
#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(PoseError, SizesEqualTheirMatrixDefinitions) {
  for (const double angle : {0.0, 1e-9, 0.01, 1.0, 3.0, std::numbers::pi}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    const Pose error{so3_exp(angle * axis), {0.3, -0.4, 1.2}};
    const Eigen::Matrix4d off = error.matrix() - Eigen::Matrix4d::Identity();
    EXPECT_NEAR(size_of(error, Relation::translation), 1.3, 1e-12);
    EXPECT_NEAR(size_of(error, Relation::rotation_angle), angle / kDegree, 1e-9);
    EXPECT_NEAR(size_of(error, Relation::rotation_part), (off.topLeftCorner<3, 3>().norm()), 1e-12);
    EXPECT_NEAR(size_of(error, Relation::full), off.norm(), 1e-12);
  }
}

TEST(PoseError, SplitIntoHorizontalAndVertical) {
  const Pose reference{from_roll_pitch_yaw({0.1, 0.2, 2.0}), {1.0, 2.0, 3.0}};
  Pose estimate = reference;
  estimate.translation += Eigen::Vector3d(3.0, 4.0, -2.0);
  const SplitError split = split_error(reference, estimate);
  EXPECT_NEAR(split.horizontal, 5.0, 1e-12);
  EXPECT_NEAR(split.vertical, 2.0, 1e-12);
  EXPECT_NEAR(split.tilt, 0.0, 1e-6);
  EXPECT_NEAR(split.yaw, 0.0, 1e-6);
}

TEST(PoseError, YawIsFreeOfTiltAndTiltOfYaw) {
  for (const double heading : {-3.0, 0.0, 1.5}) {
    const Pose reference{from_roll_pitch_yaw({0.05, -0.1, heading}), {0.0, 0.0, 0.0}};
    // A turn about the world's vertical leaves the body's vertical axis where it is.
    const Pose turned{from_roll_pitch_yaw({0.0, 0.0, -20.0 * kDegree}) * reference.rotation,
                      {0.0, 0.0, 0.0}};
    EXPECT_NEAR(split_error(reference, turned).yaw, 20.0, 1e-9);
    EXPECT_NEAR(split_error(reference, turned).tilt, 0.0, 1e-6);
    const Eigen::Vector3d level(std::cos(0.7), std::sin(0.7), 0.0);
    const Pose tilted{so3_exp(7.0 * kDegree * level) * reference.rotation, {0.0, 0.0, 0.0}};
    EXPECT_NEAR(split_error(reference, tilted).tilt, 7.0, 1e-9);
    EXPECT_NEAR(split_error(reference, tilted).yaw, 0.0, 1e-6);
    const double between = std::acos((reference.rotation * Eigen::Vector3d::UnitZ())
                                         .dot(tilted.rotation * Eigen::Vector3d::UnitZ()));
    EXPECT_LE(between / kDegree, 7.0 + 1e-9);
    // A quaternion and its negative are one turn.
    const Pose again{Eigen::Quaterniond(-turned.rotation.coeffs()), {0.0, 0.0, 0.0}};
    EXPECT_NEAR(split_error(reference, again).yaw, 20.0, 1e-9);
    EXPECT_NEAR(split_error(reference, again).tilt, 0.0, 1e-6);
  }
}

TEST(AbsoluteErrors, OneForEachPairWhateverTheFrameOfTheBodies) {
  const Trajectory reference = test::winding_walk(20);
  Trajectory estimate = reference;
  for (StampedPose& stamped : estimate) stamped.pose.translation.z() += 0.25;
  const std::vector<double> errors = absolute_errors({reference, estimate}, Relation::translation);
  ASSERT_EQ(errors.size(), 20U);
  for (const double error : errors) EXPECT_NEAR(error, 0.25, 1e-12);
  for (const SplitError& split : absolute_split_errors({reference, estimate})) {
    EXPECT_NEAR(split.vertical, 0.25, 1e-12);
    EXPECT_NEAR(split.horizontal, 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace surefoot::evaluation
