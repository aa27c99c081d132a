// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// People who go with the robot: beside it, ahead of it, and standing in front of it when it stops.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/gait.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"

namespace surefoot::simulation {

/// @param rays answers for the scene without them. @param duration of the walk [s].
[[nodiscard]] std::vector<MovingObject> make_companions(int count, const Scene& scene,
                                                        const RayCaster& rays,
                                                        const GaitModel& gait, double duration,
                                                        std::uint64_t seed);

}  // namespace surefoot::simulation
