// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Trajectories with known properties.
#pragma once

#include <cmath>

#include "evaluation/association.hpp"

namespace surefoot::evaluation::test {

inline StampedPose stamped(double seconds, const Eigen::Vector3d& position,
                           const Eigen::Vector3d& angles = Eigen::Vector3d::Zero()) {
  return {std::llround(1e9 * seconds), {from_roll_pitch_yaw(angles), position}};
}

/// A winding walk in space, ten poses a second.
inline Trajectory winding_walk(int poses) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    const double s = 0.1 * i;
    trajectory.push_back(
        stamped(s, {3.0 * std::sin(0.5 * s) + 0.4 * s, 2.0 * std::cos(0.3 * s), 0.3 * std::sin(s)},
                {0.1 * std::sin(s), 0.1 * std::cos(2.0 * s), 0.3 * s}));
  }
  return trajectory;
}

/// Straight ahead along x, `step` metres a pose, one pose a second.
inline Trajectory straight_walk(int poses, double step) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) trajectory.push_back(stamped(i, {step * i, 0.0, 0.0}));
  return trajectory;
}

/// The trajectory as seen from another world frame.
inline Trajectory moved(Trajectory trajectory, const Pose& motion, double scale = 1.0) {
  for (StampedPose& pose : trajectory) {
    pose.pose.translation *= scale;
    pose.pose = motion * pose.pose;
  }
  return trajectory;
}

}  // namespace surefoot::evaluation::test
