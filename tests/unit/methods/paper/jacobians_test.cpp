// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Jacobians (14) and (24), updates and their two parts, eqs. (2), (3), (17), (27).
#include <gtest/gtest.h>

#include "methods/paper/horizontal.hpp"
#include "methods/paper/matches.hpp"
#include "methods/paper/vertical.hpp"
#include "registration_fixture.hpp"
#include "support/matrix_exponential.hpp"

namespace surefoot {
namespace {

using test::Random;

/// A source point in the map after an update: what the residuals (13) and (23) contain.
Eigen::Vector3d place_after(const Pose& T_map_lidar, const Twist& delta,
                            const Eigen::Vector3d& point) {
  return apply_update(T_map_lidar, delta) * point;
}

Eigen::Matrix<double, 3, 6> numerical_point_jacobian(const Pose& T_map_lidar,
                                                     const Eigen::Vector3d& point) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 3, 6> J;
  for (int i = 0; i < 6; ++i) {
    const Twist delta = kStep * Twist::Unit(i);
    J.col(i) = (place_after(T_map_lidar, delta, point) - place_after(T_map_lidar, -delta, point)) /
               (2.0 * kStep);
  }
  return J;
}

TEST(Jacobians, PointJacobianIsTheDerivativeOfThePlaceUnderAnUpdate) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose T = random.pose(100.0, 3.0);
    const Eigen::Vector3d point = random.vector(30.0);
    const Eigen::Matrix<double, 3, 6> J = point_jacobian(T.rotation * point);
    EXPECT_LT((J - numerical_point_jacobian(T, point)).norm(), 1e-6);
  }
}

TEST(Jacobians, PlaneJacobianIsTheDerivativeOfThePlaneResidualUnderAnUpdate) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Pose T = random.pose(100.0, 3.0);
    const Eigen::Vector3d point = random.vector(30.0), n = random.unit_vector();
    const Eigen::Matrix<double, 1, 6> expected = n.transpose() * numerical_point_jacobian(T, point);
    EXPECT_LT((plane_jacobian(T.rotation * point, n) - expected).norm(), 1e-6);
  }
}

TEST(Jacobians, AreThePapersMatricesAboutTheSensor) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d s = random.vector(30.0), n = random.unit_vector();
    Eigen::Matrix<double, 3, 6> J_p;
    J_p << Eigen::Matrix3d::Identity(), -test::skew(s);
    EXPECT_EQ(point_jacobian(s), J_p);
    EXPECT_LT((plane_jacobian(s, n) - n.transpose() * J_p).norm(), 1e-13);
  }
}

TEST(Jacobians, UpdateTurnsAboutTheSensorByTheExponential) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Pose T = random.pose(1e4, 3.0);
    const Twist delta = random.twist(1.0, 0.5);
    const Pose updated = apply_update(T, delta);
    // exp(delta) in a frame with the map's axes and its origin at the sensor.
    Eigen::Matrix4d T_sensor_lidar = T.matrix();
    T_sensor_lidar.topRightCorner<3, 1>().setZero();
    Eigen::Matrix4d expected = test::matrix_exponential(delta) * T_sensor_lidar;
    expected.topRightCorner<3, 1>() += T.translation;
    EXPECT_LT((updated.matrix() - expected).norm(), 1e-11);
  }
}

TEST(Jacobians, SourceAndTargetAreSeenFromTheSensor) {
  Random random(5);
  const Pose T = random.pose(100.0, 3.0);
  const Eigen::Vector3f point(1.0F, 2.0F, 3.0F);
  Match match;
  match.found = true;
  match.target = random.vector(100.0);
  const SensorMatch seen = about_sensor(T.rotation.toRotationMatrix(), T.translation, point, match);
  const Eigen::Vector3d place = T * point.cast<double>();
  EXPECT_LT((seen.s - (place - T.translation)).norm(), 1e-12);
  EXPECT_LT(((seen.s - seen.q) - (place - match.target)).norm(), 1e-12);
}

TEST(Jacobians, HorizontalAndVerticalUpdatesArePlacedByTheSelectionMatrices) {
  Eigen::Matrix<double, 6, 3> S_H, S_V;
  S_H << 1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 0, /**/ 0, 0, 0, /**/ 0, 0, 0, /**/ 0, 0, 1;
  S_V << 0, 0, 0, /**/ 0, 0, 0, /**/ 1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 1, /**/ 0, 0, 0;
  const Eigen::Vector3d delta_H(1.0, 2.0, 3.0), delta_V(4.0, 5.0, 6.0);
  EXPECT_EQ(full_horizontal_update(delta_H), S_H * delta_H);
  EXPECT_EQ(full_vertical_update(delta_V), S_V * delta_V);
}

TEST(Jacobians, TheTwoPartsMakeUpTheWholeState) {
  const Twist whole = (Twist() << 1, 2, 3, 4, 5, 6).finished();
  const Twist H = full_horizontal_update({whole[0], whole[1], whole[5]});
  const Twist V = full_vertical_update({whole[2], whole[3], whole[4]});
  EXPECT_EQ(H + V, whole);
  EXPECT_EQ(H.dot(V), 0.0);
}

}  // namespace
}  // namespace surefoot
