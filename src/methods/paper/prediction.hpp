// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The motion that a scan is deskewed by, section 3.2: the last one, clamped and cut into segments.
#pragma once

#include <cstdint>

#include "core/last_motion.hpp"
#include "methods/paper/paper_parameters.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// Where the sensor is believed to be at the start and the end of a scan.
struct MotionPrior {
  Pose T_start;  ///< T_s
  Pose T_end;    ///< T_f
};

/// T_s and T_f (section 3.2): the last velocity carried on to the scan's first and last instant.
/// Beyond `max_extrapolation` [s] after the last pose the prediction stands still: a velocity says
/// nothing about a long gap. The scan's own motion is predicted all the same.
[[nodiscard]] MotionPrior predict_motion(const LastMotion& motion, std::int64_t start_ns,
                                         std::int64_t end_ns, double max_extrapolation);

/// The corrected twist of eq. (6): x, y and yaw stay, z, roll and pitch are clipped.
[[nodiscard]] Twist clamp_twist(const Twist& twist, const PaperParameters::Deskew& config);

/// I(T_a, T_b, u) of eq. (8): slerp of the rotation, linear in the translation.
[[nodiscard]] Pose interpolate(const Pose& T_a, const Pose& T_b, double u);

/// The predicted motion within the scan, eqs. (5)-(9), Algorithm 1 lines 1-6. With
/// DeskewMode::constant_velocity (and none) it is the prior's one twist, not clamped.
[[nodiscard]] ScanTrajectory predict_trajectory(const MotionPrior& prior, std::int64_t start_ns,
                                                std::int64_t end_ns,
                                                const PaperParameters::Deskew& config);

}  // namespace surefoot
