// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/body_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/ground_path.hpp"
#include "simulation/ray_caster.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeStride = 111;
constexpr std::uint64_t kPurposeAmplitude = 112;
constexpr std::uint64_t kPurposeWander = 113;
constexpr std::uint64_t kPurposeImpact = 114;
constexpr std::uint64_t kPurposeStumble = 115;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

void add_harmonics(const GaitModel& gait, const std::vector<WalkState>& states,
                   const std::vector<double>& phases, std::uint64_t seed,
                   std::vector<PoseAngles>& offsets) {
  const CounterRandom random(seed, kPurposeAmplitude);
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (states[k].activity == 0.0) continue;
    for (int axis = 0; axis < kBodyAxes; ++axis) {
      const double variation = std::max(
          0.0, 1.0 + gait.amplitude_variation *
                         smooth_noise(random, static_cast<std::uint64_t>(axis), phases[k]));
      double sum = 0.0;
      for (const Harmonic& harmonic : gait.harmonics[static_cast<std::size_t>(axis)]) {
        sum += harmonic.amplitude * std::sin(kTwoPi * harmonic.order * phases[k] + harmonic.phase);
      }
      offsets[k](axis) += states[k].activity * variation * sum;
    }
  }
}

void add_wander(const GaitModel& gait, const std::vector<WalkState>& states, std::uint64_t seed,
                std::vector<PoseAngles>& offsets) {
  if (gait.wander_tilt == 0.0 && gait.wander_position == 0.0) return;
  const CounterRandom random(seed, kPurposeWander);
  for (std::size_t k = 0; k < states.size(); ++k) {
    const double parameter = kMotionStep * static_cast<double>(k) / gait.wander_step;
    for (int axis = 0; axis < kBodyAxes; ++axis) {
      const double size = axis < kRoll ? gait.wander_position : gait.wander_tilt;
      offsets[k](axis) += states[k].activity * size *
                          smooth_noise(random, static_cast<std::uint64_t>(axis), parameter);
    }
  }
}

/// Ringing after one footfall, from its state on.
void add_impact(const GaitModel& gait, std::size_t first, double activity, double side,
                const CounterRandom& random, std::uint64_t counter,
                std::vector<PoseAngles>& offsets) {
  constexpr double kOnset = 0.006;  // [s]
  constexpr double kDecay = 0.035;
  constexpr double kLast = 0.4;
  const double frequency = random.uniform(counter, gait.impact_low_hz, gait.impact_high_hz);
  const double strength = activity * random.uniform(counter + 1, 0.5, 1.5);
  const double pitch_share = random.uniform(counter + 2, -1.0, 1.0);
  const auto count =
      std::min(offsets.size() - first, static_cast<std::size_t>(kLast / kMotionStep));
  for (std::size_t i = 0; i < count; ++i) {
    const double time = kMotionStep * static_cast<double>(i);
    const double onset = 1.0 - std::exp(-time / kOnset);
    const double ring =
        strength * onset * onset * std::exp(-time / kDecay) * std::sin(kTwoPi * frequency * time);
    PoseAngles& offset = offsets[first + i];
    offset(kBounce) -= gait.impact_bounce * ring;
    offset(kRoll) += side * gait.impact_tilt * ring;
    offset(kPitch) += pitch_share * gait.impact_tilt * ring;
  }
}

void add_impacts(const GaitModel& gait, const std::vector<WalkState>& states,
                 const std::vector<double>& phases, std::uint64_t seed,
                 std::vector<PoseAngles>& offsets) {
  const CounterRandom random(seed, kPurposeImpact);
  std::uint64_t impact = 0;
  for (std::size_t k = 1; k < states.size(); ++k) {
    for (std::size_t foot = 0; foot < gait.footfalls.size(); ++foot) {
      const double shift = gait.footfalls[foot];
      if (std::floor(phases[k] - shift) == std::floor(phases[k - 1] - shift)) continue;
      add_impact(gait, k, states[k].activity, foot % 2 == 0 ? 1.0 : -1.0, random, 4 * impact,
                 offsets);
      ++impact;
    }
  }
}

/// One stumble: the body drops and tilts and comes back, without a kink at either end.
void add_stumble(const GaitModel& gait, std::size_t first, double activity,
                 const CounterRandom& random, std::uint64_t counter,
                 std::vector<PoseAngles>& offsets) {
  const double duration = random.uniform(counter, 0.3, 0.6);
  const double pitch = random.uniform(counter + 1, 0.4, 1.0);
  const double roll = random.uniform(counter + 2, -1.0, 1.0);
  const double yaw = random.uniform(counter + 3, -0.5, 0.5);
  const auto count =
      std::min(offsets.size() - first, static_cast<std::size_t>(duration / kMotionStep));
  for (std::size_t i = 0; i < count; ++i) {
    const double x = kMotionStep * static_cast<double>(i) / duration;
    const double hump = 4.0 * x * (1.0 - x);
    const double bump = activity * hump * hump * hump;
    offsets[first + i](kBounce) -= gait.stumble_drop * pitch * bump;
    offsets[first + i](kPitch) += gait.stumble_tilt * pitch * bump;
    offsets[first + i](kRoll) += gait.stumble_tilt * roll * bump;
    offsets[first + i](kYaw) += gait.stumble_tilt * yaw * bump;
  }
}

void add_stumbles(const GaitModel& gait, const std::vector<WalkState>& states, std::uint64_t seed,
                  std::vector<PoseAngles>& offsets) {
  if (gait.stumbles_per_minute <= 0.0) return;
  const CounterRandom random(seed, kPurposeStumble);
  const double mean_gap = 60.0 / gait.stumbles_per_minute;
  double time = 0.0;
  for (std::uint64_t stumble = 0;; ++stumble) {
    // Exponential gaps; the 2 s keep two stumbles apart.
    time += 2.0 - (mean_gap - 2.0) * std::log(1.0 - random.uniform(8 * stumble));
    const auto first = static_cast<std::size_t>(time / kMotionStep);
    if (first >= offsets.size()) return;
    add_stumble(gait, first, states[first].activity, random, 8 * stumble + 1, offsets);
  }
}

}  // namespace

std::vector<double> stride_phases(const GaitModel& gait, const std::vector<WalkState>& states,
                                  std::uint64_t seed) {
  constexpr double kFrequencyLag = 0.1;  // a new cadence is taken up within this time [s]
  const CounterRandom random(seed, kPurposeStride);
  std::vector<double> phases(states.size());
  double phase = 0.0;
  double frequency = gait.stride_frequency;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto stride = static_cast<std::uint64_t>(phase);
    const double wanted =
        gait.stride_frequency *
        (1.0 + gait.stride_variation * std::clamp(random.normal(stride), -3.0, 3.0));
    frequency += (wanted - frequency) * kMotionStep / kFrequencyLag;
    const double pace = states[k].activity > 0.02 ? 1.0 : 0.0;
    phase += pace * frequency * kMotionStep;
    phases[k] = phase;
  }
  return phases;
}

std::vector<PoseAngles> oscillate(const GaitModel& gait, const std::vector<WalkState>& states,
                                  std::uint64_t seed) {
  std::vector<PoseAngles> offsets(states.size(), PoseAngles::Zero());
  add_wander(gait, states, seed, offsets);
  add_stumbles(gait, states, seed, offsets);
  if (gait.stride_frequency > 0.0) {
    const std::vector<double> phases = stride_phases(gait, states, seed);
    add_harmonics(gait, states, phases, seed, offsets);
    add_impacts(gait, states, phases, seed, offsets);
  }
  return offsets;
}

Motion make_motion(const Scene& scene, const RayCaster& rays, const GaitModel& gait,
                   double duration, std::uint64_t seed, const Pose& T_body_lidar) {
  const std::vector<WalkState> states = plan_walk(gait, duration, seed);
  const std::vector<PoseAngles> offsets = oscillate(gait, states, seed);
  const GroundPath path(scene, rays, Stance{}, states.back().distance);
  std::vector<PoseAngles> controls(states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    PoseAngles pose = path.at(states[k].distance);
    // Turned in place, the slope that was ahead is at the side.
    const double c = std::cos(states[k].turn);
    const double s = std::sin(states[k].turn);
    const double roll = pose(kRoll);
    const double pitch = pose(kPitch);
    pose(kRoll) = c * roll + s * pitch;
    pose(kPitch) = c * pitch - s * roll;
    pose(kYaw) += states[k].turn;
    const Eigen::Quaterniond resting = from_roll_pitch_yaw(pose.tail<3>());
    pose.head<3>() += resting * offsets[k].head<3>() + Eigen::Vector3d(0, 0, gait.body_height);
    pose.tail<3>() += offsets[k].tail<3>();
    controls[k] = pose;
  }
  return {std::move(controls), T_body_lidar};
}

}  // namespace surefoot::simulation
