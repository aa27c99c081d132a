// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a body moves on its legs: harmonics of the stride, impacts, stumbles, pauses. The figures
// and where they come from are in gait.cpp.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace surefoot::simulation {

/// amplitude * sin(2 pi order * stride_phase + phase)
struct Harmonic {
  int order = 1;
  double amplitude = 0.0;  ///< m or rad
  double phase = 0.0;      ///< [rad]
};

/// Indices of a body's degrees of freedom, in the order of PoseAngles.
enum BodyAxis { kSurge, kSway, kBounce, kRoll, kPitch, kYaw, kBodyAxes };

struct GaitModel {
  std::string name;
  double speed = 0.0;             ///< [m/s]
  double stride_frequency = 0.0;  ///< [Hz]; 0: no legs
  double body_height = 0.0;       ///< of the body's centre above the footholds [m]
  std::array<std::vector<Harmonic>, kBodyAxes> harmonics;

  /// Feet that touch down together, as phases of the stride in [0, 1), and the ringing of the body
  /// after each: a damped oscillation of a frequency drawn for each impact.
  std::vector<double> footfalls;
  double impact_bounce = 0.0;  ///< [m]
  double impact_tilt = 0.0;    ///< [rad], in pitch and in roll
  double impact_low_hz = 12.0;
  double impact_high_hz = 25.0;

  double stride_variation = 0.0;     ///< of the stride's duration, standard deviation, relative
  double amplitude_variation = 0.0;  ///< of every harmonic, standard deviation, relative
  double wander_tilt = 0.0;          ///< slow aimless roll, pitch and yaw, standard deviation [rad]
  double wander_position = 0.0;      ///< likewise surge, sway, bounce [m]
  double wander_step = 0.4;          ///< time scale of the wandering [s]

  double speed_variation = 0.0;  ///< relative standard deviation
  double stumbles_per_minute = 0.0;
  double stumble_tilt = 0.0;  ///< greatest pitch and roll of a stumble [rad]
  double stumble_drop = 0.0;  ///< [m]
  double pauses_per_minute = 0.0;
};

/// Names: trot, walk, stairs, run, wheel, handheld, still.
[[nodiscard]] const std::vector<std::string>& gait_names();
/// @throws std::invalid_argument that names the gaits there are.
[[nodiscard]] GaitModel gait_model(const std::string& name);
/// All amplitudes times `scale`; speed and frequencies stay.
[[nodiscard]] GaitModel scaled(GaitModel gait, double scale);

}  // namespace surefoot::simulation
