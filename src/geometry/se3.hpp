// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Calculus of small rigid motions; twists are ordered [x y z roll pitch yaw].
#pragma once

#include "surefoot/pose.hpp"

namespace surefoot {

/// Ad(T): T * se3_exp(t) == se3_exp(Ad(T) * t) * T.
[[nodiscard]] Matrix6 se3_adjoint(const Pose& pose);

/// [R 0; 0 R]: a twist in other axes, or a covariance of twists as M * C * M^T.
[[nodiscard]] inline Matrix6 turned_axes(const Eigen::Quaterniond& rotation) {
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = rotation.toRotationMatrix();
  return turn;
}

/// Inverse of the right Jacobian: se3_log(se3_exp(t) * se3_exp(d)) is t + J_r^-1(t) * d for small
/// d; the rotation of t is shorter than pi. After Barfoot, State Estimation for Robotics, 7.1.5.
[[nodiscard]] Matrix6 se3_right_jacobian_inverse(const Twist& twist);

/// As its rotation's: 0 to pi [rad].
[[nodiscard]] double turn_angle(const Pose& motion);

/// Nearest motion about the vertical that brings a frame's z axis upright: keeps the place and the
/// heading of x.
[[nodiscard]] Pose upright(const Pose& pose);

}  // namespace surefoot
