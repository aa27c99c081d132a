// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/scenes.hpp"
#include "simulation/scenes/vegetation.hpp"

namespace surefoot::simulation {

namespace {
constexpr std::uint64_t kPurposeHilltop = 210;
constexpr double kHalf = 62.0;  // [m]
}  // namespace

Scene hilltop(const SceneSeeds& seeds) {
  const CounterRandom random(seeds.layout, kPurposeHilltop);
  Terrain ground(CounterRandom(seeds.layout, kPurposeHilltop + 50));
  ground.add_hill(random.uniform(10, 7.0, 12.0), random.uniform(11, 26.0, 34.0));
  ground.add_waves(24.0, random.uniform(12, 0.5, 0.9));
  ground.add_waves(7.0, random.uniform(13, 0.12, 0.2));
  ground.add_waves(2.2, 0.06, 6);
  ground.add_waves(0.8, 0.025, 6);
  Scene scene;
  scene.mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.25, ground, Material::grass);
  scene.route = winding_loop(ground, random.uniform(14, 30.0, 36.0), random);

  // No trunk, no stone of any size: tufts up to the way, behind them grass to the sensor's height
  // and above, and bushes.
  Vegetation plants(scene, ground, kHalf, seeds.things);
  plants.add_grass(thinning_out(300.0, 10.0, 3.5), random.uniform(15, 0.6, 0.9));
  plants.add_herbs(thinning_out(6.0, 0.8, 5.0), random.uniform(16, 0.5, 0.9));
  plants.add_bushes(beside_way(random.uniform(17, 0.09, 0.14), 0.9), random.uniform(18, 1.4, 2.4));
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  scene.view_margin = 6.0;
  return scene;
}

}  // namespace surefoot::simulation
