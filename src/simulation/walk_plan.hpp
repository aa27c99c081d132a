// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When the robot walks, how fast, where it pauses and looks round.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/gait.hpp"
#include "simulation/random.hpp"

namespace surefoot::simulation {

/// What the robot does at one instant.
struct WalkState {
  double distance = 0.0;  ///< walked so far [m]
  double turn = 0.0;      ///< heading against the way's, from turning in place [rad]
  double activity = 0.0;  ///< 0: the legs stand, 1: they walk at full speed
};

/// States every kMotionStep, the first one step before time 0 and the last after `duration`.
[[nodiscard]] std::vector<WalkState> plan_walk(const GaitModel& gait, double duration,
                                               std::uint64_t seed);

/// Standard normal noise, C2 in time, that changes over about one unit of `parameter`.
/// Independent for every `channel`.
[[nodiscard]] double smooth_noise(const CounterRandom& random, std::uint64_t channel,
                                  double parameter);

/// Number of controls that a Motion of `duration` seconds needs.
[[nodiscard]] std::size_t motion_controls(double duration);

}  // namespace surefoot::simulation
