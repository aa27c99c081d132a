// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposePlayground = 204;

/// A pitch is crowned by a few centimetres so that rain runs off.
double pitch_ground(double x, double y) {
  return 0.12 * (1.0 - (y / 34.0) * (y / 34.0)) + 0.008 * std::sin(0.8 * x) * std::sin(0.6 * y);
}

void add_goal(TriangleMesh& mesh, double x, double direction) {
  const double z = pitch_ground(x, 0.0) - 0.05;
  for (const double y : {-3.66, 3.66}) {
    mesh.add_column({x, y, z}, 0.06, 2.5, Material::kPaintedMetal);
    mesh.add_column({x + 1.5 * direction, y, z}, 0.03, 2.0, Material::kPaintedMetal);
  }
  mesh.add_box({x - 0.06, -3.72, z + 2.44}, {x + 0.06, 3.72, z + 2.56}, Material::kPaintedMetal);
}

void add_fence(TriangleMesh& mesh) {
  const auto run = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const int posts = static_cast<int>((b - a).norm() / 3.0);
    for (int i = 0; i < posts; ++i) {
      const Eigen::Vector2d p = a + (b - a) * (static_cast<double>(i) / posts);
      mesh.add_column({p.x(), p.y(), -1.5}, 0.05, 2.8, Material::kPaintedMetal, 8);
    }
    for (const double z : {0.2, 0.6, 1.0}) {
      mesh.add_quad({a.x(), a.y(), z}, {b.x(), b.y(), z}, {b.x(), b.y(), z + 0.08},
                    {a.x(), a.y(), z + 0.08}, Material::kPaintedMetal);
    }
  };
  run({-52, -36}, {52, -36});
  run({52, -36}, {52, 36});
  run({52, 36}, {-52, 36});
  run({-52, 36}, {-52, -36});
}

}  // namespace

Scene playground(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposePlayground);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_heightfield({-80, -60}, {80, 60}, 1.0, pitch_ground, Material::kGrass);
  add_goal(mesh, -45.0, -1.0);
  add_goal(mesh, 45.0, 1.0);
  add_fence(mesh);
  for (const double x : {-20.0, 8.0, 30.0}) add_bench(mesh, {x, 33.5, pitch_ground(x, 33.5)}, 0.0);
  for (std::uint64_t i = 0; i < 9; ++i) {
    const double x = -70.0 + 17.0 * static_cast<double>(i) + random.uniform(8000 * i + 1, -3, 3);
    add_tree(mesh, {x, 46.0, pitch_ground(x, 46.0)}, random.uniform(8000 * i + 2, 6, 10), random,
             i + 1);
  }
  for (const double x : {-40.0, 0.0, 40.0}) add_lamp(mesh, {x, -33.0, pitch_ground(x, -33.0)});
  add_building(mesh, {-20.0, -58.0}, {24.0, -46.0}, 1, pitch_ground(0.0, -50.0));
  constexpr int kCorners = 24;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCorners;
    const double x = 16.0 * std::sin(angle);
    const double y = -9.0 * std::cos(angle);
    scene.route.emplace_back(x, y, pitch_ground(x, y));
  }
  scene.robot = "trot";
  scene.view_margin = 30.0;
  return scene;
}

}  // namespace surefoot::simulation
