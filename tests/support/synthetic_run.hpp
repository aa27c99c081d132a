// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Whole runs of the odometry through synthetic scenes, and their errors against the truth.
#pragma once

#include <string>
#include <vector>

#include "support/scene.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::test {

/// Motions of the LiDAR in the scenes: x forward, the floor at z = 0.
[[nodiscard]] MotionFunction standing(const Pose& T_world_lidar);
/// From `T_start` at a constant body velocity [m/s, rad/s].
[[nodiscard]] MotionFunction constant_velocity(const Pose& T_start, const Twist& velocity);
/// Walking forward at `speed` [m/s] with a trot of `hertz`: height, roll and pitch sway.
[[nodiscard]] MotionFunction trotting(const Pose& T_start, double speed, double hertz);
/// Walking over ramp_yard(slope_deg) from `start_x`, the body parallel to the ground beneath,
/// smoothed over a body's length.
[[nodiscard]] MotionFunction climbing(double start_x, double speed, double slope_deg);
/// The same motion of a LiDAR that is mounted turned: T_world_lidar * T_lidar_mounted.
[[nodiscard]] MotionFunction mounted(const MotionFunction& motion, const Pose& T_lidar_mounted);

/// Scans from `first`, one after another, `count` of them.
[[nodiscard]] std::vector<Scan> take_scans(const Scene& scene, const MotionFunction& motion,
                                           int count, const Scanner& scanner = {}, int first = 0);
[[nodiscard]] std::vector<Estimate> add_scans(Odometry& odometry, const std::vector<Scan>& scans);

/// How far a run strays from the truth when both begin with the same pose.
struct Error {
  double translation = 0.0;  ///< [m] largest of all scans
  double vertical = 0.0;     ///< [m] of these, along z
  double rotation_deg = 0.0;
  double final_translation = 0.0;
};
[[nodiscard]] Error error_against(const std::vector<Estimate>& estimates,
                                  const MotionFunction& motion, const Scanner& scanner = {});

/// Statuses of a run, one word a scan, for a test's message.
[[nodiscard]] std::string statuses(const std::vector<Estimate>& estimates);

/// Whether two estimates agree in every bit of pose, covariance and report.
[[nodiscard]] bool same_bits(const Estimate& a, const Estimate& b);
[[nodiscard]] bool same_bits(const std::vector<Estimate>& a, const std::vector<Estimate>& b);

[[nodiscard]] double angle_between_deg(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

}  // namespace surefoot::test
