// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A picture of a scene: seen from above at an angle, without perspective, its route drawn in.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"

namespace surefoot::simulation {

struct SceneImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> argb;  ///< row by row from the top, opaque
};

/// The route's surroundings, `width` pixels wide.
[[nodiscard]] SceneImage render_scene(const Scene& scene, const RayCaster& rays, int width);

}  // namespace surefoot::simulation
