// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/gait.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace surefoot::simulation {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;
constexpr double kGravity = 9.81;
constexpr double kHalfTurn = kPi / 2.0;

/// Harmonics of the bounce of a run with flight: a parabola in the air and half a sine on the
/// ground that joins it with equal speed, twice a stride.
std::vector<Harmonic> flight_bounce(double stride_frequency, double flight_fraction) {
  const double step = 0.5 / stride_frequency;
  const double flight = flight_fraction * step;
  const double stance = step - flight;
  const double touchdown_speed = 0.5 * kGravity * flight;
  const auto height = [&](double time) {
    if (time < flight) return 0.5 * kGravity * time * (flight - time);
    return -touchdown_speed * stance / kPi * std::sin(kPi * (time - flight) / stance);
  };
  std::vector<Harmonic> harmonics;
  constexpr int kSamples = 2000;
  for (int order = 1; order <= 3; ++order) {
    double sine = 0.0;
    double cosine = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double part = static_cast<double>(i) / kSamples;
      const double value = height(part * step) * 2.0 / kSamples;
      sine += value * std::sin(2.0 * kPi * order * part);
      cosine += value * std::cos(2.0 * kPi * order * part);
    }
    harmonics.push_back({2 * order, std::hypot(sine, cosine), std::atan2(cosine, sine)});
  }
  return harmonics;
}

/// A trotter of the Unitree Go2's size. What the figures stand on:
/// - stride 2.5 Hz: small quadrupeds are driven at 1.5 to 4 Hz (Margolis and Agrawal, "Walk These
///   Ways", CoRL 2022, arXiv:2212.03238); a trot's two touchdowns a stride
///   make bounce and pitch beat at twice it, roll, sway and yaw at once it;
/// - body height 0.31 m: the base of a Go2 stands at 0.28 to 0.34 m in its maker's and in published
///   controllers;
/// - bounce 7 mm: as feet cannot pull, its acceleration (2 pi 5 Hz)^2 * 7 mm = 6.9 m/s^2 must stay
///   below gravity in a trot without flight;
/// - tilts of 1 to 1.5 deg: half a scan's change stays well inside the 0.2 rad and 0.5 m that Han
/// et
///   al., "Deskewed LiDAR Odometry for Quadruped Robots" (2026), section 3.2, chose as limits for a
///   Go2's motion within one scan. They are the model's choice, not a measurement: --gait-scale
///   spans the doubt.
GaitModel trot() {
  GaitModel gait;
  gait.name = "trot";
  gait.speed = 1.2;
  gait.stride_frequency = 2.5;
  gait.body_height = 0.31;
  gait.harmonics[kSurge] = {{2, 0.004, 0.3}};
  gait.harmonics[kSway] = {{1, 0.007, 0.0}, {3, 0.001, 0.4}};
  gait.harmonics[kBounce] = {{2, 0.007, 0.0}, {4, 0.0015, 0.9}, {1, 0.001, 0.5}};
  gait.harmonics[kRoll] = {{1, 1.5 * kDegree, 0.2}, {3, 0.3 * kDegree, 1.1}};
  gait.harmonics[kPitch] = {
      {2, 1.1 * kDegree, 0.8}, {1, 0.3 * kDegree, 0.0}, {4, 0.2 * kDegree, 0.3}};
  gait.harmonics[kYaw] = {{1, 1.0 * kDegree, kHalfTurn}, {2, 0.2 * kDegree, 0.0}};
  gait.footfalls = {0.0, 0.5};
  gait.impact_bounce = 0.0012;
  gait.impact_tilt = 0.25 * kDegree;
  gait.stride_variation = 0.04;
  gait.amplitude_variation = 0.12;
  gait.wander_tilt = 0.4 * kDegree;
  gait.wander_position = 0.004;
  gait.speed_variation = 0.08;
  gait.stumbles_per_minute = 2.0;
  gait.stumble_tilt = 5.0 * kDegree;
  gait.stumble_drop = 0.03;
  gait.pauses_per_minute = 2.0;
  return gait;
}

GaitModel walk() {
  GaitModel gait = trot();
  gait.name = "walk";
  gait.speed = 0.5;
  gait.stride_frequency = 2.0;
  gait.harmonics[kSway] = {{1, 0.012, 0.0}, {3, 0.001, 0.4}};
  gait.harmonics[kBounce] = {{2, 0.004, 0.0}, {4, 0.001, 0.9}};
  gait.harmonics[kRoll] = {{1, 2.0 * kDegree, 0.2}, {3, 0.3 * kDegree, 1.1}};
  gait.harmonics[kPitch] = {{2, 0.8 * kDegree, 0.8}, {1, 0.4 * kDegree, 0.0}};
  gait.harmonics[kYaw] = {{1, 1.2 * kDegree, kHalfTurn}};
  gait.footfalls = {0.0, 0.25, 0.5, 0.75};
  gait.impact_bounce = 0.0006;
  gait.impact_tilt = 0.15 * kDegree;
  return gait;
}

GaitModel stairs() {
  GaitModel gait = walk();
  gait.name = "stairs";
  gait.speed = 0.4;
  gait.harmonics[kBounce] = {{2, 0.008, 0.0}, {4, 0.002, 0.9}};
  gait.harmonics[kPitch] = {{2, 1.8 * kDegree, 0.8}, {1, 0.8 * kDegree, 0.0}};
  gait.harmonics[kRoll] = {{1, 2.5 * kDegree, 0.2}, {3, 0.4 * kDegree, 1.1}};
  gait.impact_bounce = 0.0015;
  gait.impact_tilt = 0.35 * kDegree;
  gait.stumbles_per_minute = 4.0;
  return gait;
}

GaitModel run() {
  GaitModel gait = trot();
  gait.name = "run";
  gait.speed = 2.8;
  gait.stride_frequency = 3.0;
  gait.harmonics[kSurge] = {{2, 0.006, 0.3}};
  gait.harmonics[kBounce] = flight_bounce(gait.stride_frequency, 0.5);
  gait.harmonics[kRoll] = {{1, 1.8 * kDegree, 0.2}, {3, 0.4 * kDegree, 1.1}};
  gait.harmonics[kPitch] = {{2, 2.0 * kDegree, 0.8}, {1, 0.5 * kDegree, 0.0}};
  gait.impact_bounce = 0.002;
  gait.impact_tilt = 0.45 * kDegree;
  return gait;
}

/// For comparison: four wheels without suspension on the same ground.
GaitModel wheel() {
  GaitModel gait;
  gait.name = "wheel";
  gait.speed = 1.2;
  gait.body_height = 0.31;
  gait.wander_tilt = 0.05 * kDegree;
  gait.wander_position = 0.0005;
  gait.wander_step = 0.05;
  gait.speed_variation = 0.05;
  gait.pauses_per_minute = 2.0;
  return gait;
}

/// For comparison: a person who carries the sensor before the chest.
GaitModel handheld() {
  GaitModel gait;
  gait.name = "handheld";
  gait.speed = 1.1;
  gait.stride_frequency = 0.9;
  gait.body_height = 1.2;
  gait.harmonics[kSway] = {{1, 0.02, 0.0}};
  gait.harmonics[kBounce] = {{2, 0.02, 0.0}};
  gait.harmonics[kRoll] = {{1, 1.5 * kDegree, 0.2}};
  gait.harmonics[kPitch] = {{2, 1.0 * kDegree, 0.8}};
  gait.harmonics[kYaw] = {{1, 2.0 * kDegree, kHalfTurn}};
  gait.stride_variation = 0.03;
  gait.amplitude_variation = 0.2;
  gait.wander_tilt = 4.0 * kDegree;
  gait.wander_position = 0.03;
  gait.wander_step = 0.8;
  gait.speed_variation = 0.1;
  gait.pauses_per_minute = 2.0;
  return gait;
}

GaitModel still() {
  GaitModel gait;
  gait.name = "still";
  gait.body_height = 0.31;
  return gait;
}

}  // namespace

const std::vector<std::string>& gait_names() {
  static const std::vector<std::string> names = {"trot",  "walk",     "stairs", "run",
                                                 "wheel", "handheld", "still"};
  return names;
}

GaitModel gait_model(const std::string& name) {
  if (name == "trot") return trot();
  if (name == "walk") return walk();
  if (name == "stairs") return stairs();
  if (name == "run") return run();
  if (name == "wheel") return wheel();
  if (name == "handheld") return handheld();
  if (name == "still") return still();
  std::string known;
  for (const std::string& other : gait_names()) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument("no robot is called '" + name + "'; there are: " + known);
}

GaitModel scaled(GaitModel gait, double scale) {
  for (std::vector<Harmonic>& axis : gait.harmonics) {
    for (Harmonic& harmonic : axis) harmonic.amplitude *= scale;
  }
  for (double* amplitude : {&gait.impact_bounce, &gait.impact_tilt, &gait.wander_tilt,
                            &gait.wander_position, &gait.stumble_tilt, &gait.stumble_drop}) {
    *amplitude *= scale;
  }
  return gait;
}

}  // namespace surefoot::simulation
