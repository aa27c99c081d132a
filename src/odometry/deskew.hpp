// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "odometry/motion_prior.hpp"
#include "odometry/parallel.hpp"
#include "odometry/preprocess.hpp"
#include "surefoot/config.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// The corrected twist of eq. (6): x, y and yaw stay, z, roll and pitch are clipped.
[[nodiscard]] Twist clamp_twist(const Twist& twist, const Config::Deskew& config);

/// I(T_a, T_b, u) of eq. (8): slerp of the rotation, linear in the translation.
[[nodiscard]] Pose interpolate(const Pose& T_a, const Pose& T_b, double u);

/// The predicted motion within the scan, eqs. (5)-(9), Algorithm 1 lines 1-6. With
/// DeskewMode::constant_velocity (and none) it is the prior's one twist, not clamped.
[[nodiscard]] ScanTrajectory predict_trajectory(const MotionPrior& prior, std::int64_t start_ns,
                                                std::int64_t end_ns, const Config::Deskew& config);

/// The scan's points at its mid-scan instant, in the LiDAR frame of that instant [m]: eqs.
/// (10)-(12), Algorithm 1 line 7. Points without times stay where they are.
[[nodiscard]] std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan,
                                                  const ScanTrajectory& trajectory,
                                                  const Config::Deskew& config,
                                                  const Workers& workers);

}  // namespace surefoot
