// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/scenes.hpp"
#include "simulation/scenes/vegetation.hpp"

namespace surefoot::simulation {

namespace {
constexpr std::uint64_t kPurposeHillside = 209;
constexpr double kHalf = 64.0;  // [m]
}  // namespace

Scene hillside(const SceneSeeds& seeds) {
  const CounterRandom random(seeds.layout, kPurposeHillside);
  Terrain ground(CounterRandom(seeds.layout, kPurposeHillside + 50));
  ground.add_slope({random.uniform(10, 0.10, 0.19), random.uniform(11, -0.05, 0.05)});
  ground.add_waves(38.0, random.uniform(12, 0.9, 1.6));
  ground.add_waves(9.0, random.uniform(13, 0.18, 0.3));
  ground.add_waves(2.6, random.uniform(14, 0.04, 0.07), 6);
  ground.add_waves(0.9, 0.018, 6);
  Scene scene;
  scene.mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.25, ground, Material::grass);
  scene.route = winding_loop(ground, random.uniform(15, 30.0, 37.0), random);

  Vegetation plants(scene, ground, kHalf, seeds.things);
  plants.add_grass(thinning_out(random.uniform(23, 15.0, 60.0), 4.0, 5.0),
                   random.uniform(16, 0.25, 0.45));
  plants.add_herbs(thinning_out(1.6, 0.3, 8.0), random.uniform(17, 0.4, 0.7));
  plants.add_bushes(beside_way(random.uniform(18, 0.03, 0.06), 0.9), random.uniform(19, 1.0, 1.8));
  plants.add_trees(beside_way(random.uniform(20, 0.03, 0.06), 1.2), random.uniform(21, 8.0, 14.0));
  plants.add_dead_wood(beside_way(0.01, 1.0));
  plants.add_stones(thinning_out(0.8, 0.2, 8.0), random.uniform(22, 0.4, 0.7));
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  scene.view_margin = 6.0;
  return scene;
}

}  // namespace surefoot::simulation
