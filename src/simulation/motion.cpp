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

}  // namespace surefoot::simulation
