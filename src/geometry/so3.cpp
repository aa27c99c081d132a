// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/so3.hpp"

#include <cmath>

#include "surefoot/pose.hpp"

namespace surefoot {

namespace {
// Below this angle the closed forms lose digits to cancellation and the series is exact to 1e-16.
constexpr double kSmallAngle = 1e-2;
}  // namespace

Eigen::Matrix3d so3_left_jacobian(const Eigen::Vector3d& rotation_vector) {
  const double t2 = rotation_vector.squaredNorm();
  const double t = std::sqrt(t2);
  double a, b;  // (1 - cos t) / t^2 and (t - sin t) / t^3
  if (t < kSmallAngle) {
    a = 0.5 - t2 / 24.0 * (1.0 - t2 / 30.0 * (1.0 - t2 / 56.0));
    b = 1.0 / 6.0 - t2 / 120.0 * (1.0 - t2 / 42.0 * (1.0 - t2 / 72.0));
  } else {
    a = (1.0 - std::cos(t)) / t2;
    b = (t - std::sin(t)) / (t2 * t);
  }
  const Eigen::Matrix3d k = hat(rotation_vector);
  return Eigen::Matrix3d::Identity() + a * k + b * k * k;
}

Eigen::Matrix3d so3_left_jacobian_inverse(const Eigen::Vector3d& rotation_vector) {
  const double t2 = rotation_vector.squaredNorm();
  const double t = std::sqrt(t2);
  double c;  // (1 - t/2 cot(t/2)) / t^2
  if (t < kSmallAngle) {
    c = 1.0 / 12.0 + t2 / 720.0 * (1.0 + t2 / 42.0 * (1.0 + t2 / 40.0));
  } else {
    const double half = 0.5 * t;
    c = (1.0 - half * std::cos(half) / std::sin(half)) / t2;
  }
  const Eigen::Matrix3d k = hat(rotation_vector);
  return Eigen::Matrix3d::Identity() - 0.5 * k + c * k * k;
}

double turn_angle(const Eigen::Quaterniond& rotation) { return so3_log(rotation).norm(); }

Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized();
  const Eigen::Vector3d b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond turn;
  if (cosine < -1.0 + 1e-12) {
    turn.w() = 0.0;
    turn.vec() = a.unitOrthogonal();
    return turn;
  }
  const double twice_w = std::sqrt((1.0 + cosine) * 2.0);  // by the half-angle formula
  turn.vec() = a.cross(b) * (1.0 / twice_w);
  turn.w() = twice_w * 0.5;
  if (cosine < 0.0) turn.normalize();  // nearly opposite, 1 + cosine has few digits
  return turn;
}

}  // namespace surefoot
