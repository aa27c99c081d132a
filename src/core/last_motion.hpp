// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "surefoot/seconds.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// The last pose and how the sensor moved when it was taken.
struct LastMotion {
  StampedPose last;                ///< T_map_lidar at mid-scan of the last scan
  Twist velocity = Twist::Zero();  ///< [m/s, rad/s] LiDAR frame
};

/// Two poses that are nearer to each other in time tell of no velocity: millimetres of noise would
/// be metres a second [s].
inline constexpr double kLeastElapsed = 0.01;

/// The motion after a newly registered pose; the velocity stays where too little time has passed.
[[nodiscard]] inline LastMotion next_motion(const LastMotion& motion, const StampedPose& pose) {
  const double elapsed = seconds(pose.stamp_ns - motion.last.stamp_ns);
  if (elapsed < kLeastElapsed) return {pose, motion.velocity};
  return {pose, se3_log(motion.last.pose.inverse() * pose.pose) / elapsed};
}

}  // namespace surefoot
