// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The body on its way: the ground under it, the walk's plan, and the gait's oscillation on top.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/gait.hpp"
#include "simulation/motion.hpp"
#include "simulation/walk_plan.hpp"

namespace surefoot::simulation {

class RayCaster;
struct Scene;

/// Strides done at every state. The legs stand still where the robot does.
[[nodiscard]] std::vector<double> stride_phases(const GaitModel& gait,
                                                const std::vector<WalkState>& states,
                                                std::uint64_t seed);

/// Deviation of the body from its resting pose over the footholds, one a state: surge, sway,
/// bounce [m], roll, pitch, yaw [rad].
[[nodiscard]] std::vector<PoseAngles> oscillate(const GaitModel& gait,
                                                const std::vector<WalkState>& states,
                                                std::uint64_t seed);

/// The whole motion of a robot over a scene's route.
/// @throws std::invalid_argument where the route has no ground.
[[nodiscard]] Motion make_motion(const Scene& scene, const RayCaster& rays, const GaitModel& gait,
                                 double duration, std::uint64_t seed, const Pose& T_body_lidar);

}  // namespace surefoot::simulation
