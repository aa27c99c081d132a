// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/walk_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/motion.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposePauses = 101;
constexpr std::uint64_t kPurposeSpeed = 102;
constexpr double kStandAtStart = 1.0;  // [s]
constexpr double kSpeedUp = 1.2;
constexpr double kSlowDown = 0.7;
constexpr double kSpeedStep = 2.0;  // the speed wanders over this time [s]

struct Keyframe {
  double time = 0.0;
  double speed = 0.0;  ///< relative to the gait's
  double activity = 0.0;
  double turn = 0.0;
};

/// 6x^5 - 15x^4 + 10x^3: from 0 to 1 with no speed and no acceleration at both ends.
double smoother_step(double x) {
  const double u = std::clamp(x, 0.0, 1.0);
  return u * u * u * (u * (6.0 * u - 15.0) + 10.0);
}

/// A pause: slow down, stand or turn to one side and back, speed up.
void add_pause(std::vector<Keyframe>& frames, double time, const CounterRandom& random,
               std::uint64_t counter) {
  const auto add = [&](double after, double speed, double activity, double turn) {
    time += after;
    frames.push_back({time, speed, activity, turn});
  };
  add(0.0, 1.0, 1.0, 0.0);
  add(kSlowDown, 0.0, 0.0, 0.0);
  if (random.uniform(counter) < 0.5) {
    const double side = random.uniform(counter + 1) < 0.5 ? -1.0 : 1.0;
    const double angle = side * random.uniform(counter + 2, 40.0, 90.0) * std::numbers::pi / 180.0;
    add(0.3, 0.0, 0.6, 0.0);
    add(1.4, 0.0, 0.6, angle);
    add(0.4, 0.0, 0.6, angle);
    add(1.4, 0.0, 0.6, 0.0);
    add(0.3, 0.0, 0.0, 0.0);
  } else {
    add(random.uniform(counter + 3, 0.5, 2.0), 0.0, 0.0, 0.0);
  }
  add(kSpeedUp, 1.0, 1.0, 0.0);
}

std::vector<Keyframe> keyframes(const GaitModel& gait, double duration, std::uint64_t seed) {
  std::vector<Keyframe> frames = {{0.0, 0.0, 0.0, 0.0}};
  if (gait.speed <= 0.0) return frames;
  frames.push_back({kStandAtStart, 0.0, 0.0, 0.0});
  frames.push_back({kStandAtStart + kSpeedUp, 1.0, 1.0, 0.0});
  if (gait.pauses_per_minute <= 0.0) return frames;
  const CounterRandom random(seed, kPurposePauses);
  const double gap = 60.0 / gait.pauses_per_minute;
  for (std::uint64_t pause = 0;; ++pause) {
    const double next = frames.back().time + gap * random.uniform(8 * pause + 7, 0.5, 1.3);
    if (next > duration) break;
    add_pause(frames, next, random, 8 * pause);
  }
  return frames;
}

Keyframe interpolate(const std::vector<Keyframe>& frames, double time) {
  const auto after =
      std::upper_bound(frames.begin(), frames.end(), time,
                       [](double value, const Keyframe& frame) { return value < frame.time; });
  if (after == frames.begin()) return frames.front();
  if (after == frames.end()) return frames.back();
  const Keyframe& a = *(after - 1);
  const Keyframe& b = *after;
  const double part = smoother_step((time - a.time) / (b.time - a.time));
  return {time, a.speed + part * (b.speed - a.speed), a.activity + part * (b.activity - a.activity),
          a.turn + part * (b.turn - a.turn)};
}

}  // namespace

double smooth_noise(const CounterRandom& random, std::uint64_t channel, double parameter) {
  // A spline's smoothing takes variance away: this gives it back, averaged over a step.
  constexpr double kRestore = 1.0 / 0.6917;
  constexpr std::uint64_t kChannelStride = 1ULL << 32;
  const double knot = std::floor(parameter);
  const auto counter =
      channel * kChannelStride + static_cast<std::uint64_t>(static_cast<std::int64_t>(knot) + 16);
  const auto [w0, w1, w2, w3] = bspline_weights(parameter - knot);
  return kRestore * (w0 * random.normal(counter) + w1 * random.normal(counter + 1) +
                     w2 * random.normal(counter + 2) + w3 * random.normal(counter + 3));
}

std::size_t motion_controls(double duration) {
  return static_cast<std::size_t>(std::ceil(duration / kMotionStep)) + 4;
}

std::vector<WalkState> plan_walk(const GaitModel& gait, double duration, std::uint64_t seed) {
  const std::vector<Keyframe> frames = keyframes(gait, duration, seed);
  const CounterRandom random(seed, kPurposeSpeed);
  std::vector<WalkState> states(motion_controls(duration));
  double distance = 0.0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const double time = kMotionStep * (static_cast<double>(k) - 1.0);
    const Keyframe now = interpolate(frames, time);
    const double wander = gait.speed_variation * smooth_noise(random, 0, time / kSpeedStep);
    distance += kMotionStep * gait.speed * now.speed * std::max(0.0, 1.0 + wander);
    states[k] = {distance, now.turn, now.activity};
  }
  return states;
}

}  // namespace surefoot::simulation
