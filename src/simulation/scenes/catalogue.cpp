// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

const std::vector<SceneEntry>& scene_catalogue() {
  static const std::vector<SceneEntry> entries = {
      {"campus", "loop between buildings, up a ramp to a terrace and down again", &campus},
      {"parking", "three storeys with straight ramps, columns and parked cars", &parking},
      {"stairwell", "dog-leg stairs over four floors, a hall on each", &stairwell},
      {"playground", "open flat ground, little to hold on to but a fence and goals", &playground},
      {"forest", "wooded hill, uneven ground", &forest},
      {"corridor", "60 m of bare corridor with shallow doors, there and back", &corridor},
      {"rubble", "field of broken slabs underfoot", &rubble},
      {"plaza", "town square with walking people and passing cars", &plaza},
      {"hillside", "slope with undergrowth, grass, stones and trees that sway", &hillside},
      {"hilltop", "hill grown over with grass and bushes, hardly anything flat", &hilltop},
      {"forest-path", "gravel path over roots, between hedges and trees", &forest_path},
      {"foyer", "hall behind glass, a room of glass in it", &foyer},
      {"storeys", "four storeys that look alike, round each up and down", &storeys},
      {"bays", "hall of equal bays, up and down its aisles", &bays},
      {"street", "two blocks of equal houses, a figure eight round them", &street},
      {"town", "four streets round a block, 1.3 km a lap", &town},
      {"quarter", "seven streets, a figure eight round their two blocks", &quarter},
      {"avenue", "a bent street, out and back on its other side, 1 km", &avenue},
      {"city", "21 km of streets round eight by eight blocks", &city},
  };
  return entries;
}

Scene build_scene(const std::string& name, const SceneSeeds& seeds) {
  std::string known;
  for (const SceneEntry& entry : scene_catalogue()) {
    if (entry.name == name) {
      Scene scene = entry.build(seeds);
      scene.name = entry.name;
      scene.description = entry.description;
      return scene;
    }
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument("no scene is called '" + name + "'; there are: " + known);
}

}  // namespace surefoot::simulation
