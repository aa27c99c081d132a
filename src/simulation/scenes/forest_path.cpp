// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <cmath>

#include "simulation/scenes/scenes.hpp"
#include "simulation/scenes/vegetation.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeForestPath = 211;
constexpr double kHalf = 62.0;  // [m]
constexpr double kPathHalfWidth = 1.1;
constexpr double kStretch = 7.0;  // of path that has a hedge beside it, or has none

/// Roots every few metres, hedges along some stretches.
void add_along_path(Vegetation& plants, const std::vector<Eigen::Vector3d>& route,
                    const CounterRandom& random) {
  double since_root = 0.0;
  double since_hedge = 0.0;
  Eigen::Vector2d hedge_from = route.front().head<2>();
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const Eigen::Vector2d here = route[i].head<2>();
    const Eigen::Vector2d step = route[i + 1].head<2>() - here;
    const Eigen::Vector2d left = Eigen::Vector2d(-step.y(), step.x()).normalized();
    const std::uint64_t draw = 1000 + 16 * i;
    since_root += step.norm();
    since_hedge += step.norm();
    if (since_root > random.uniform(draw, 1.5, 6.0)) {
      const double side = random.uniform(draw + 1) < 0.5 ? -1.0 : 1.0;
      const Eigen::Vector2d slanted = random.uniform(draw + 2, -0.8, 0.8) * step.normalized();
      plants.add_root(here - side * 1.6 * left, here + side * 1.4 * left + slanted,
                      random.uniform(draw + 3, 0.025, 0.06), i);
      since_root = 0.0;
    }
    if (since_hedge < kStretch) continue;
    for (const double side : {-1.0, 1.0}) {
      const std::uint64_t own = draw + (side > 0.0 ? 4 : 8);
      if (random.uniform(own) > 0.3) continue;
      const double away = side * random.uniform(own + 1, 1.7, 2.3);
      plants.add_hedge(hedge_from + away * left, here + away * left,
                       random.uniform(own + 2, 1.0, 1.9), 2 * i + (side > 0.0 ? 1 : 0));
    }
    hedge_from = here;
    since_hedge = 0.0;
  }
}

}  // namespace

Scene forest_path(const SceneSeeds& seeds) {
  const CounterRandom random(seeds.layout, kPurposeForestPath);
  Terrain ground(CounterRandom(seeds.layout, kPurposeForestPath + 50));
  ground.add_slope({random.uniform(10, -0.05, 0.05), random.uniform(11, -0.05, 0.05)});
  ground.add_waves(34.0, random.uniform(12, 0.8, 1.6));
  ground.add_waves(8.0, random.uniform(13, 0.1, 0.2));
  ground.add_waves(2.0, 0.025, 6);
  Scene scene;
  scene.mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.25, ground, Material::earth);
  scene.route = winding_loop(ground, random.uniform(14, 30.0, 37.0), random);

  const auto off_path = [](double near, double far) {
    const Density thinning = thinning_out(near, far, 6.0);
    return [=](double distance) { return distance < kPathHalfWidth ? 0.0 : thinning(distance); };
  };
  Vegetation plants(scene, ground, kHalf, seeds.things);
  plants.add_stones([](double distance) { return distance < kPathHalfWidth ? 18.0 : 0.15; },
                    random.uniform(15, 0.25, 0.5));  // gravel on the path
  plants.add_grass(off_path(45.0, 3.0), random.uniform(16, 0.3, 0.5));
  plants.add_herbs(off_path(1.5, 0.3), random.uniform(17, 0.4, 0.8));
  plants.add_bushes(beside_way(random.uniform(18, 0.04, 0.08), 1.6), random.uniform(19, 1.0, 2.0));
  plants.add_trees(beside_way(random.uniform(20, 0.04, 0.09), 1.6), random.uniform(21, 9.0, 15.0));
  plants.add_dead_wood(beside_way(0.015, 1.4));
  add_along_path(plants, scene.route, random);
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  scene.view_margin = 6.0;
  scene.view_ceiling = 11.0;
  return scene;
}

}  // namespace surefoot::simulation
