// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The scenes that the program brings along, one file each. A layout's seed draws buildings, ground,
// ramps, stairs and route; the seed of things what grows, is strewn about and walks.
#pragma once

#include "simulation/scene.hpp"

namespace surefoot::simulation {

[[nodiscard]] Scene campus(const SceneSeeds& seeds);
[[nodiscard]] Scene parking(const SceneSeeds& seeds);
[[nodiscard]] Scene stairwell(const SceneSeeds& seeds);
[[nodiscard]] Scene playground(const SceneSeeds& seeds);
[[nodiscard]] Scene forest(const SceneSeeds& seeds);
[[nodiscard]] Scene corridor(const SceneSeeds& seeds);
[[nodiscard]] Scene rubble(const SceneSeeds& seeds);
[[nodiscard]] Scene plaza(const SceneSeeds& seeds);
[[nodiscard]] Scene hillside(const SceneSeeds& seeds);
[[nodiscard]] Scene hilltop(const SceneSeeds& seeds);
[[nodiscard]] Scene forest_path(const SceneSeeds& seeds);
[[nodiscard]] Scene foyer(const SceneSeeds& seeds);
// Places that look alike, and ways that return: for loops.
[[nodiscard]] Scene storeys(const SceneSeeds& seeds);
[[nodiscard]] Scene bays(const SceneSeeds& seeds);
[[nodiscard]] Scene street(const SceneSeeds& seeds);
// Longer than any local map is wide.
[[nodiscard]] Scene town(const SceneSeeds& seeds);
[[nodiscard]] Scene quarter(const SceneSeeds& seeds);
[[nodiscard]] Scene avenue(const SceneSeeds& seeds);
[[nodiscard]] Scene city(const SceneSeeds& seeds);

}  // namespace surefoot::simulation
