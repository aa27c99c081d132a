// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeCorridor = 206;
constexpr double kLength = 60.0;  // [m]
constexpr double kHalfWidth = 1.2;
constexpr double kHeight = 2.7;
constexpr double kDoorEvery = 5.0;
constexpr double kDoorWidth = 0.95;
constexpr double kDoorHeight = 2.05;
constexpr double kDoorDepth = 0.08;  // doors hardly stand back: along the corridor all looks alike

/// One long wall at y = side * kHalfWidth with shallow doors.
void add_wall(TriangleMesh& mesh, double side) {
  const double y = side * kHalfWidth;
  const double back = y + side * kDoorDepth;
  const auto panel = [&](double x0, double x1, double at, double z0, double z1) {
    mesh.add_quad({x0, at, z0}, {x1, at, z0}, {x1, at, z1}, {x0, at, z1}, Material::kConcrete);
  };
  double x = 0.0;
  for (double door = 0.5 * kDoorEvery; door < kLength; door += kDoorEvery) {
    panel(x, door, y, 0.0, kHeight);
    panel(door, door + kDoorWidth, y, kDoorHeight, kHeight);
    panel(door, door + kDoorWidth, back, 0.0, kDoorHeight);
    for (const double edge : {door, door + kDoorWidth}) {
      mesh.add_quad({edge, y, 0.0}, {edge, back, 0.0}, {edge, back, kDoorHeight},
                    {edge, y, kDoorHeight}, Material::kConcrete);
    }
    mesh.add_quad({door, y, kDoorHeight}, {door + kDoorWidth, y, kDoorHeight},
                  {door + kDoorWidth, back, kDoorHeight}, {door, back, kDoorHeight},
                  Material::kConcrete);
    x = door + kDoorWidth;
  }
  panel(x, kLength, y, 0.0, kHeight);
}

}  // namespace

Scene corridor(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposeCorridor);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  const double w = kHalfWidth + kDoorDepth;
  mesh.add_quad({0, -w, 0}, {kLength, -w, 0}, {kLength, w, 0}, {0, w, 0}, Material::kConcrete);
  mesh.add_quad({0, -w, kHeight}, {kLength, -w, kHeight}, {kLength, w, kHeight}, {0, w, kHeight},
                Material::kConcrete);
  for (const double x : {0.0, kLength}) {
    mesh.add_quad({x, -w, 0}, {x, w, 0}, {x, w, kHeight}, {x, -w, kHeight}, Material::kBrick);
  }
  add_wall(mesh, -1.0);
  add_wall(mesh, 1.0);
  // The only things that tell one place from another: a few radiators and extinguishers.
  for (std::uint64_t i = 0; i < 4; ++i) {
    const double x = 15.0 * static_cast<double>(i) + random.uniform(2 * i, 4.0, 6.0);
    const double side = random.uniform(2 * i + 1) < 0.5 ? -1.0 : 1.0;
    const double inner = side * (kHalfWidth - 0.1);
    const double outer = side * kHalfWidth;
    mesh.add_box({x, std::min(inner, outer), 0.15}, {x + 0.9, std::max(inner, outer), 0.75},
                 Material::kPaintedMetal);
  }
  scene.route = {{2.0, -0.55, 0},         {kLength - 2.0, -0.55, 0},
                 {kLength - 1.5, 0.0, 0}, {kLength - 2.0, 0.55, 0},
                 {2.0, 0.55, 0},          {1.5, 0.0, 0}};
  scene.corner_rounding = 0.2;
  scene.robot = "trot";
  scene.view_ceiling = kHeight - 0.1;
  scene.view_margin = 2.0;
  return scene;
}

}  // namespace surefoot::simulation
