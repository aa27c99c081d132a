// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

const std::vector<SceneEntry>& scene_catalogue() {
  static const std::vector<SceneEntry> entries = {
      {"campus", "loop between buildings, up a ramp to a terrace and down again", &campus},
  };
  return entries;
}

Scene build_scene(const std::string& name, std::uint64_t seed) {
  std::string known;
  for (const SceneEntry& entry : scene_catalogue()) {
    if (entry.name == name) {
      Scene scene = entry.build(seed);
      scene.name = entry.name;
      scene.description = entry.description;
      return scene;
    }
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument("no scene is called '" + name + "'; there are: " + known);
}

}  // namespace surefoot::simulation
