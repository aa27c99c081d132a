// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Pictures of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"
#include "simulation/scene_view.hpp"

namespace surefoot::simulation {

/// Where a ray meets nothing.
inline constexpr std::uint32_t kSky = 0xffeef2f5;

struct SceneImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> argb;  ///< row by row from the top, opaque
};

/// What stands in view.
[[nodiscard]] SceneImage render_view(const SceneView& view, const RayCaster& rays);
/// The route's surroundings with the route drawn in, `width` pixels wide.
[[nodiscard]] SceneImage render_scene(const Scene& scene, const RayCaster& rays, int width);

}  // namespace surefoot::simulation
