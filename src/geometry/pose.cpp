// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/pose.hpp"

#include <cmath>

#include "geometry/so3.hpp"

namespace surefoot {

Eigen::Matrix4d Pose::matrix() const {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = rotation.toRotationMatrix();
  result.topRightCorner<3, 1>() = translation;
  return result;
}

Eigen::Quaterniond so3_exp(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  const double half = 0.5 * angle;
  // sin(half)/angle; below 1e-4 the next term of the series is 1e-18.
  const double scale = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  Eigen::Quaterniond rotation;
  rotation.w() = std::cos(half);
  rotation.vec() = scale * rotation_vector;
  return rotation.normalized();
}

Eigen::Vector3d so3_log(const Eigen::Quaterniond& rotation) {
  // q and -q are one rotation; w >= 0 gives the shorter way round.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d vec = sign * rotation.vec();
  const double w = sign * rotation.w();
  const double sine = vec.norm();
  if (sine < 1e-7) return 2.0 / w * vec;
  // atan2 stays exact near pi, where w is near zero and acos would lose half of its digits.
  return 2.0 * std::atan2(sine, w) / sine * vec;
}

Pose se3_exp(const Twist& twist) {
  const Eigen::Vector3d rotation_vector = twist.tail<3>();
  return {so3_exp(rotation_vector), so3_left_jacobian(rotation_vector) * twist.head<3>()};
}

Twist se3_log(const Pose& pose) {
  Twist twist;
  const Eigen::Vector3d rotation_vector = so3_log(pose.rotation);
  twist.tail<3>() = rotation_vector;
  twist.head<3>() = so3_left_jacobian_inverse(rotation_vector) * pose.translation;
  return twist;
}

Eigen::Vector3d roll_pitch_yaw(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d r = rotation.toRotationMatrix();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double pitch = std::atan2(-r(2, 0), cosine);
  if (cosine < 1e-7) return {0.0, pitch, std::atan2(-r(0, 1), r(1, 1))};  // roll and yaw are one
  return {std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0))};
}

Eigen::Quaterniond from_roll_pitch_yaw(const Eigen::Vector3d& angles) {
  const Eigen::Vector3d half = 0.5 * angles;
  return from_half_angles(SineCosine(half.x()), SineCosine(half.y()), SineCosine(half.z()));
}

}  // namespace surefoot
