// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Rigid motions. `T_a_b` takes a point from frame b to frame a; metres and radians.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace surefoot {

/// A twist or an increment, ordered as in the paper's eq. (2): [x y z roll pitch yaw], translation
/// first; m and rad (or m/s and rad/s for a velocity).
using Twist = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A rigid motion T_a_b: rotation (unit quaternion), then translation [m].
struct Pose {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  /// The point, given in frame b, in frame a.
  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return rotation * point + translation;
  }
  /// T_a_c = T_a_b * T_b_c. The rotation is normalised, so chains of any length stay rigid.
  [[nodiscard]] Pose operator*(const Pose& other) const {
    return {(rotation * other.rotation).normalized(), rotation * other.translation + translation};
  }
  [[nodiscard]] Pose inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation)};
  }
  /// Homogeneous: it takes [x y z 1] from frame b to frame a.
  [[nodiscard]] Eigen::Matrix4d matrix() const;
};

/// Rotation of a rotation vector [rad]; exact near zero.
[[nodiscard]] Eigen::Quaterniond so3_exp(const Eigen::Vector3d& rotation_vector);
/// Rotation vector [rad] of a rotation, its norm in [0, pi]; exact near zero and near pi.
[[nodiscard]] Eigen::Vector3d so3_log(const Eigen::Quaterniond& rotation);
/// Rigid motion of a twist: the motion made in one unit of time at constant body velocity.
[[nodiscard]] Pose se3_exp(const Twist& twist);
/// Twist of a rigid motion; se3_exp(se3_log(T)) == T.
[[nodiscard]] Twist se3_log(const Pose& pose);

/// Roll, pitch, yaw [rad] with R = Rz(yaw) Ry(pitch) Rx(roll); pitch in [-pi/2, pi/2]. Straight up
/// or down, where roll and yaw turn about one axis, roll is zero.
[[nodiscard]] Eigen::Vector3d roll_pitch_yaw(const Eigen::Quaterniond& rotation);
[[nodiscard]] Eigen::Quaterniond from_roll_pitch_yaw(const Eigen::Vector3d& roll_pitch_yaw);

}  // namespace surefoot
