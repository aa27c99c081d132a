// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/so3.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// x -> T exp(u xi) x: a point measured at the share u of a segment that begins at T and moves by
/// xi, eq. (11). The rotation axis is the same for the whole segment, so a point costs one sine
/// and one cosine.
class SegmentMotion {
 public:
  SegmentMotion(const Pose& T_start, const Twist& twist)
      : rotation_(T_start.rotation.toRotationMatrix()),
        translation_(T_start.translation),
        velocity_(twist.head<3>()),
        angle_(twist.tail<3>().norm()) {
    if (angle_ < kNoRotation) return;
    const Eigen::Vector3d axis = twist.tail<3>() / angle_;
    turn_ = hat(axis);
    turn2_ = turn_ * turn_;
    turn_velocity_ = turn_ * velocity_ / angle_;
    turn2_velocity_ = turn2_ * velocity_ / angle_;
  }

  [[nodiscard]] Eigen::Vector3d operator()(double u, const Eigen::Vector3d& point) const {
    Eigen::Vector3d moved = point + u * velocity_;
    if (angle_ >= kNoRotation) {  // Rodrigues' formula, and the left Jacobian for the translation
      const auto [sine, versine] = sine_and_versine(u * angle_);
      moved += sine * (turn_ * point) + versine * (turn2_ * point) + versine * turn_velocity_ +
               (u * angle_ - sine) * turn2_velocity_;
    }
    return rotation_ * moved + translation_;
  }

 private:
  struct Turn {
    double sine, versine;  // 1 - cosine
  };
  /// Within a segment angles are small, and few terms of the series as exact as a library's call.
  [[nodiscard]] static Turn sine_and_versine(double a) {
    if (std::abs(a) > kSmall) return {std::sin(a), 1.0 - std::cos(a)};
    const double b = a * a;
    constexpr double k2 = 1.0 / 2, k6 = k2 / 3, k24 = k6 / 4, k120 = k24 / 5, k720 = k120 / 6,
                     k5040 = k720 / 7, k40320 = k5040 / 8, k362880 = k40320 / 9,
                     k3628800 = k362880 / 10;
    const double sine = a * (1.0 - b * (k6 - b * (k120 - b * (k5040 - b * k362880))));
    const double versine = b * (k2 - b * (k24 - b * (k720 - b * (k40320 - b * k3628800))));
    return {sine, versine};
  }

  static constexpr double kSmall = 0.25;       // [rad] the next terms are 2e-14 of these
  static constexpr double kNoRotation = 1e-9;  // [rad] 0.1 um at 100 m

  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
  Eigen::Vector3d velocity_;
  double angle_;
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d turn2_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d turn_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn2_velocity_ = Eigen::Vector3d::Zero();
};

}  // namespace surefoot
