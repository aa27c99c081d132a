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
    mesh.add_column({x, y, z}, 0.06, 2.5, Material::painted_metal);
    mesh.add_column({x + 1.5 * direction, y, z}, 0.03, 2.0, Material::painted_metal);
  }
  mesh.add_box({x - 0.06, -3.72, z + 2.44}, {x + 0.06, 3.72, z + 2.56}, Material::painted_metal);
}

void add_fence(TriangleMesh& mesh, const Eigen::Vector2d& half) {
  const auto run = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const int posts = static_cast<int>((b - a).norm() / 3.0);
    for (int i = 0; i < posts; ++i) {
      const Eigen::Vector2d p = a + (b - a) * (static_cast<double>(i) / posts);
      mesh.add_column({p.x(), p.y(), -1.5}, 0.05, 2.8, Material::painted_metal, 8);
    }
    for (const double z : {0.2, 0.6, 1.0}) {
      mesh.add_quad({a.x(), a.y(), z}, {b.x(), b.y(), z}, {b.x(), b.y(), z + 0.08},
                    {a.x(), a.y(), z + 0.08}, Material::painted_metal);
    }
  };
  const Eigen::Vector2d side(half.x(), -half.y());
  run(-half, side);
  run(side, half);
  run(half, -side);
  run(-side, -half);
}

}  // namespace

Scene playground(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposePlayground);
  const CounterRandom random(seeds.things, kPurposePlayground);
  // The pitch, and how far outside of it the fence runs.
  const double half_length = draw.between(1, 45.0, 36.0, 50.0);
  const double half_width = draw.between(2, 32.0, 22.0, 33.0);
  const Eigen::Vector2d fence(half_length + draw.between(3, 7.0, 3.0, 9.0), half_width + 4.0);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_heightfield({-80, -60}, {80, 60}, 1.0, pitch_ground, Material::grass);
  add_goal(mesh, -half_length, -1.0);
  add_goal(mesh, half_length, 1.0);
  add_fence(mesh, fence);
  const double bench = half_width + 1.5;
  for (const double x : {-20.0, 8.0, 30.0}) {
    add_bench(mesh, {x, bench, pitch_ground(x, bench)}, 0.0);
  }
  for (std::uint64_t i = 0; i < 9; ++i) {
    const double x = -70.0 + 17.0 * static_cast<double>(i) + random.uniform(8000 * i + 1, -3, 3);
    add_tree(mesh, {x, 46.0, pitch_ground(x, 46.0)}, random.uniform(8000 * i + 2, 6, 10), random,
             i + 1);
  }
  for (const double x : {-40.0, 0.0, 40.0}) {
    add_lamp(mesh, {x, -half_width - 1.0, pitch_ground(x, -half_width - 1.0)});
  }
  add_building(mesh, {draw.between(4, -20.0, -34.0, 0.0), -58.0},
               {draw.between(5, 24.0, 12.0, 34.0), -46.0}, draw.whole(6, 1, 1, 3),
               pitch_ground(0.0, -50.0));
  const Eigen::Vector2d reach(draw.between(7, 16.0, 11.0, 24.0), draw.between(8, 9.0, 7.0, 14.0));
  const double dent = draw.between(9, 0.0, 0.0, 0.2);
  const double dent_at = draw.between(10, 0.0, 0.0, 6.28);
  constexpr int kCorners = 24;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCorners;
    // Bends in and out, so that no two layouts are walked alike.
    const double bend = 1.0 + dent * std::sin(3.0 * angle + dent_at);
    const double x = reach.x() * bend * std::sin(angle);
    const double y = -reach.y() * bend * std::cos(angle);
    scene.route.emplace_back(x, y, pitch_ground(x, y));
  }
  scene.robot = "trot";
  scene.view_margin = 30.0;
  return scene;
}

}  // namespace surefoot::simulation
