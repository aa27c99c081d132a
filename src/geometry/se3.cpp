// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/se3.hpp"

#include <cmath>

#include "geometry/so3.hpp"

namespace surefoot {

namespace {

/// The coupling of translation and rotation in the left Jacobian of SE(3).
Eigen::Matrix3d left_coupling(const Eigen::Vector3d& rho, const Eigen::Vector3d& phi) {
  const double t2 = phi.squaredNorm();
  const double t = std::sqrt(t2);
  double a, b, c;
  if (t < 0.05) {  // the closed forms lose digits to cancellation
    a = 1.0 / 6.0 - t2 / 120.0 * (1.0 - t2 / 42.0);
    b = 1.0 / 24.0 - t2 / 720.0 * (1.0 - t2 / 56.0);
    c = 1.0 / 120.0 - t2 / 2520.0 * (1.0 - t2 / 48.0);
  } else {
    const double sine = std::sin(t);
    const double cosine = std::cos(t);
    a = (t - sine) / (t2 * t);
    b = (t2 + 2.0 * cosine - 2.0) / (2.0 * t2 * t2);
    c = (2.0 * t - 3.0 * sine + t * cosine) / (2.0 * t2 * t2 * t);
  }
  const Eigen::Matrix3d p = hat(phi);
  const Eigen::Matrix3d r = hat(rho);
  const Eigen::Matrix3d prp = p * r * p;
  return 0.5 * r + a * (p * r + r * p + prp) + b * (p * p * r + r * p * p - 3.0 * prp) +
         c * (prp * p + p * prp);
}

}  // namespace

double turn_angle(const Pose& motion) { return turn_angle(motion.rotation); }

Matrix6 se3_adjoint(const Pose& pose) {
  const Eigen::Matrix3d R = pose.rotation.toRotationMatrix();
  Matrix6 result = Matrix6::Zero();
  result.topLeftCorner<3, 3>() = R;
  result.topRightCorner<3, 3>() = hat(pose.translation) * R;
  result.bottomRightCorner<3, 3>() = R;
  return result;
}

Matrix6 se3_right_jacobian_inverse(const Twist& twist) {
  const Eigen::Vector3d rho = -twist.head<3>();
  const Eigen::Vector3d phi = -twist.tail<3>();
  const Eigen::Matrix3d inverse = so3_left_jacobian_inverse(phi);
  Matrix6 result = Matrix6::Zero();
  result.topLeftCorner<3, 3>() = inverse;
  result.topRightCorner<3, 3>() = -inverse * left_coupling(rho, phi) * inverse;
  result.bottomRightCorner<3, 3>() = inverse;
  return result;
}

Pose upright(const Pose& pose) {
  const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitX();
  const double yaw = std::atan2(ahead.y(), ahead.x());
  return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), pose.translation};
}

}  // namespace surefoot
