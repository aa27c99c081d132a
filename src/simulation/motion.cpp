// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/motion.hpp"

#include <utility>

namespace surefoot::simulation {

Motion::Motion(std::vector<PoseAngles> controls, const Pose& T_body_lidar)
    : spline_(std::move(controls), kMotionStep), T_body_lidar_(T_body_lidar) {}

Pose Motion::T_map_body(double time) const {
  const PoseAngles value = spline_(time);
  return {from_roll_pitch_yaw(value.tail<3>()), value.head<3>()};
}

void Motion::T_map_lidar(std::span<const double> times, std::span<Pose> poses) const {
  for (std::size_t i = 0; i < times.size(); ++i) poses[i] = T_map_body(times[i]);
  for (std::size_t i = 0; i < times.size(); ++i) poses[i] = poses[i] * T_body_lidar_;
}

}  // namespace surefoot::simulation
