// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/pose_error.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "geometry/se3.hpp"

namespace surefoot::evaluation {

namespace {

/// |R - I| = 2 sqrt(2) |sin(angle / 2)|, and the quaternion's vector part is sin(angle / 2) long.
double rotation_part(const Pose& error) {
  return 2.0 * std::numbers::sqrt2 * error.rotation.vec().norm();
}

}  // namespace

double size_of(const Pose& error, Relation relation) {
  switch (relation) {
    case Relation::translation:
      return error.translation.norm();
    case Relation::rotation_angle:
      return degrees(turn_angle(error));
    case Relation::rotation_part:
      return rotation_part(error);
    case Relation::full:
      return std::hypot(rotation_part(error), error.translation.norm());
  }
  throw std::invalid_argument("unknown relation");
}

std::string_view unit_of(Relation relation) {
  if (relation == Relation::translation) return "m";
  return relation == Relation::rotation_angle ? "deg" : "";
}

SplitError split_error(const Pose& reference, const Pose& estimate) {
  const Eigen::Vector3d offset = estimate.translation - reference.translation;
  // The rotation in the world frame, as swing (tilt) after twist (yaw): for q = (w, x, y, z) the
  // twist about z is (w, 0, 0, z), normalised, and the swing's half angle has the sine |(x, y)|.
  const Eigen::Quaterniond q = estimate.rotation * reference.rotation.conjugate();
  const double twist = std::hypot(q.w(), q.z()), swing = std::hypot(q.x(), q.y());
  return {offset.head<2>().norm(), std::abs(offset.z()), degrees(2.0 * std::atan2(swing, twist)),
          degrees(2.0 * std::atan2(std::abs(q.z()), std::abs(q.w())))};
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace surefoot::evaluation
