// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "surefoot/pose.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// The last pose and how the sensor moved when it was taken.
struct Motion {
  StampedPose last;                ///< T_map_lidar at mid-scan of the last scan
  Twist velocity = Twist::Zero();  ///< [m/s, rad/s] LiDAR frame
};

/// Where the sensor is believed to be at the start and the end of a scan.
struct MotionPrior {
  Pose T_start;  ///< T_s
  Pose T_end;    ///< T_f
};

/// T_s and T_f (section 3.2): the last velocity carried on to the scan's first and last instant.
/// Beyond `max_extrapolation` [s] after the last pose the prediction stands still: a velocity says
/// nothing about a long gap. The scan's own motion is predicted all the same.
[[nodiscard]] MotionPrior predict_motion(const Motion& motion, std::int64_t start_ns,
                                         std::int64_t end_ns, double max_extrapolation);

/// The motion after a newly registered pose.
[[nodiscard]] Motion next_motion(const Motion& motion, const StampedPose& pose);

}  // namespace surefoot
