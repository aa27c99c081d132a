// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Small rotation calculus that the library uses inside.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/sine_cosine.hpp"

namespace surefoot {

/// [v]_x, so that hat(a) * b == a.cross(b).
[[nodiscard]] inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// J_l(phi): the translation of se3_exp is J_l(phi) * rho.
[[nodiscard]] Eigen::Matrix3d so3_left_jacobian(const Eigen::Vector3d& rotation_vector);
/// Inverse of J_l; |phi| <= pi.
[[nodiscard]] Eigen::Matrix3d so3_left_jacobian_inverse(const Eigen::Vector3d& rotation_vector);

/// from_roll_pitch_yaw of angles whose halves have these sines and cosines.
[[nodiscard]] inline Eigen::Quaterniond from_half_angles(const SineCosine& roll,
                                                         const SineCosine& pitch,
                                                         const SineCosine& yaw) {
  return {yaw.cosine * pitch.cosine * roll.cosine + yaw.sine * pitch.sine * roll.sine,
          yaw.cosine * pitch.cosine * roll.sine - yaw.sine * pitch.sine * roll.cosine,
          yaw.cosine * pitch.sine * roll.cosine + yaw.sine * pitch.cosine * roll.sine,
          yaw.sine * pitch.cosine * roll.cosine - yaw.cosine * pitch.sine * roll.sine};
}

/// By how much it turns, about whatever axis [rad], 0 to pi.
[[nodiscard]] double turn_angle(const Eigen::Quaterniond& rotation);

/// The shortest turn that brings one direction to another, neither of them zero; of opposite ones,
/// half a turn about an axis across.
[[nodiscard]] Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from,
                                                  const Eigen::Vector3d& to);

}  // namespace surefoot
