// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/motion.hpp"

#include <utility>

#include "geometry/so3.hpp"

namespace surefoot::simulation {

Motion::Motion(std::vector<PoseAngles> controls, const Pose& T_body_lidar)
    : spline_(std::move(controls), kMotionStep), T_body_lidar_(T_body_lidar) {}

Pose Motion::T_map_body(double time) const {
  const PoseAngles value = spline_(time);
  return {from_roll_pitch_yaw(value.tail<3>()), value.head<3>()};
}

void Motion::T_map_lidar(std::span<const double> times, std::span<Pose> poses) const {
  if (times.empty()) return;
  const Eigen::Vector3d first = 0.5 * spline_(times.front()).tail<3>();
  const SineCosineNear roll(first.x());
  const SineCosineNear pitch(first.y());
  const SineCosineNear yaw(first.z());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const PoseAngles value = spline_(times[i]);
    const Eigen::Vector3d half = 0.5 * value.tail<3>();
    const Pose T_map_body{from_half_angles(roll(half.x()), pitch(half.y()), yaw(half.z())),
                          value.head<3>()};
    // A product of two unit quaternions is one without being normalised.
    poses[i] = {T_map_body.rotation * T_body_lidar_.rotation,
                T_map_body * T_body_lidar_.translation};
  }
}

}  // namespace surefoot::simulation
