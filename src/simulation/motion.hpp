// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The sensor's motion: where the LiDAR is at any nanosecond. It is one uniform cubic B-spline over
// position and roll, pitch, yaw, so it is C2 in time whatever it was made from, and cheap enough
// to be asked thrice a firing sequence.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulation/cubic_bspline.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::simulation {

/// Knots of the motion: fine enough that a 25 Hz vibration keeps 99.4 % of its amplitude.
inline constexpr double kMotionStep = 1.0 / 800.0;  // [s]

/// [x y z roll pitch yaw], m and rad; yaw unwrapped.
using PoseAngles = Eigen::Matrix<double, 6, 1>;

class Motion {
 public:
  /// @param controls poses of the body every kMotionStep, the first one step before time 0.
  /// @param T_body_lidar how the LiDAR is mounted.
  Motion(std::vector<PoseAngles> controls, const Pose& T_body_lidar);

  /// Seconds for which the motion is known.
  [[nodiscard]] double duration() const { return spline_.end(); }
  [[nodiscard]] const Pose& T_body_lidar() const { return T_body_lidar_; }
  /// @param time seconds since the recording's start.
  [[nodiscard]] Pose T_map_body(double time) const;
  [[nodiscard]] Pose T_map_lidar(double time) const { return T_map_body(time) * T_body_lidar_; }
  /// The same to 1e-15, one pose a time: faster than one by one where the times lie so close
  /// together that the body has turned little.
  void T_map_lidar(std::span<const double> times, std::span<Pose> poses) const;
  /// Body's position and angles, for spectra and derivatives.
  [[nodiscard]] PoseAngles body_angles(double time) const { return spline_(time); }

 private:
  CubicBSpline<6> spline_;
  Pose T_body_lidar_;
};

}  // namespace surefoot::simulation
