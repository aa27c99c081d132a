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

/// A trotter of the Unitree Go2's size. docs/simulation.md has the table of figures and sources;
/// here the gist, [A] to [D] as there. The amplitudes are the model's own choice, held against a
/// log of a real Go1 [A]: 17 s of walking at 2.0 strides a second, gyroscope and accelerometer.
/// - Stride 2.5 Hz: between the 2.2 Hz of Unitree's own trot [B] and the 2 to 4 Hz that a Go1
/// policy
///   is driven at [C]; a flying trot for the Go2 has 2.5 Hz [D]. A trot's two touchdowns a stride
///   make bounce and pitch beat at twice it, roll, sway and yaw at once it.
/// - Body height 0.31 m: 0.32 m in [D], 0.30 m in [C].
/// - Bounce 7 mm at twice the stride: 2.9 to 5.5 mm in [A]. As feet cannot pull, its acceleration
///   (2 pi 5 Hz)^2 * 7 mm = 6.9 m/s^2 must stay below gravity in a trot without flight.
/// - Pitch 1.1 deg at twice the stride: 1.0 to 1.5 deg in [A]. Yaw 1.0 deg at the stride: 0.8 to
///   1.9 deg, bends of the way included. Sway 7 mm: 2.7 to 6.0 mm.
/// - Roll 1.5 deg at the stride: [A] has 0.5 to 0.7 deg there and 0.3 to 0.9 deg at twice it. What
/// a
///   LiDAR feels, the rate, comes out alike: 0.35 rad/s here, 0.38 rad/s there (RMS).
/// - Impacts: 12 to 25 Hz hold 3.5 m/s^2 of vertical acceleration here, 2.1 to 3.3 m/s^2 in [A].
/// What [A] cannot tell (variation, wandering, stumbles, pauses) is chosen; --gait-scale spans the
/// doubt.
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

/// Slower and one foot after the other. Stride and amplitudes are the trot's, changed by judgement:
/// less bounce, more roll and sway. Published walks are slower (0.8 to 1.25 strides a second in
/// [B], [D]); 2 Hz keeps a scan's motion at what is hard about a quadruped.
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

/// The walk with harder and more irregular steps; by judgement, no measurement stands behind it.
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

/// A trot with flight. The bounce is mechanics: free fall for half of each step. [D]'s flying trot
/// flies for a quarter of it, Unitree's running trot [B] touches the ground for 0.35 of a stride.
/// Tilts are the trot's, raised by judgement.
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

/// For comparison: a person who carries the sensor before the chest. 54.3 strides a minute are what
/// walking humans prefer (J. Exp. Biol. 210, 3255, 2007); the amplitudes are chosen.
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
