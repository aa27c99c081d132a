// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <array>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeParking = 202;
constexpr double kStorey = 3.0;  // [m]
constexpr double kSlab = 0.25;
constexpr double kLength = 40.0;      // x
constexpr double kWidth = 30.0;       // y
constexpr double kRampFrom = 10.0;    // x; a ramp rises one storey from here ...
constexpr double kRampTo = 28.0;      // ... to here: 9.5 deg
constexpr double kSouthStrip = 4.0;   // ramps down lie in y < 4
constexpr double kNorthStrip = 26.0;  // ramps up lie in y > 26

void add_slab(TriangleMesh& mesh, double z) {
  const auto plate = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, z - kSlab}, {x1, y1, z}, Material::kConcrete);
  };
  plate(0.0, 0.0, kRampFrom, kWidth);
  plate(kRampTo, 0.0, kLength, kWidth);
  plate(kRampFrom, kSouthStrip, kRampTo, kNorthStrip);
}

/// Ramp from `bottom` up by one storey in the strip between two y; towards x in both strips.
void add_ramp(TriangleMesh& mesh, double bottom, double y0, double y1) {
  const double top = bottom + kStorey;
  mesh.add_quad({kRampFrom, y0, bottom}, {kRampTo, y0, top}, {kRampTo, y1, top},
                {kRampFrom, y1, bottom}, Material::kConcrete);
  mesh.add_quad({kRampFrom, y0, bottom - kSlab}, {kRampTo, y0, top - kSlab},
                {kRampTo, y1, top - kSlab}, {kRampFrom, y1, bottom - kSlab}, Material::kConcrete);
}

void add_parapets(TriangleMesh& mesh, double z, bool over_ramps) {
  const auto wall = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, z}, {x1, y1, z + 1.0}, Material::kConcrete);
  };
  wall(0.0, 0.0, kLength, 0.15);
  wall(0.0, kWidth - 0.15, kLength, kWidth);
  wall(0.0, 0.15, 0.15, kWidth - 0.15);
  wall(kLength - 0.15, 0.15, kLength, kWidth - 0.15);
  if (!over_ramps) return;
  wall(kRampFrom, kSouthStrip, kRampTo, kSouthStrip + 0.15);
  wall(kRampFrom, kNorthStrip - 0.15, kRampTo, kNorthStrip);
}

void add_columns(TriangleMesh& mesh, double z) {
  for (double x = 8.0; x <= 32.0; x += 8.0) {
    for (const double y : {7.5, 22.5}) {
      mesh.add_box({x - 0.25, y - 0.25, z}, {x + 0.25, y + 0.25, z + kStorey - kSlab},
                   Material::kConcrete);
    }
  }
}

void add_cars(TriangleMesh& mesh, double z, const CounterRandom& random, std::uint64_t first) {
  const TriangleMesh car = make_car();
  std::uint64_t bay = first;
  for (double x = 10.5; x < 31.0; x += 2.7, ++bay) {
    for (const double y : {19.5, 8.5}) {
      const std::uint64_t draw = 4 * bay + (y > 15.0 ? 2 : 0);
      if (random.uniform(draw) < 0.35) continue;
      mesh.add_mesh(placed(car, {x, y, z}, 1.5708 + random.uniform(draw + 1, -0.05, 0.05)));
    }
  }
}

}  // namespace

Scene parking(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposeParking);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_quad({-60, -60, -0.001}, {100, -60, -0.001}, {100, 90, -0.001}, {-60, 90, -0.001},
                Material::kAsphalt);
  for (int storey = 0; storey < 3; ++storey) {
    const double z = kStorey * storey;
    if (storey > 0) add_slab(mesh, z);
    add_parapets(mesh, z, storey > 0);
    if (storey < 2) {
      add_columns(mesh, z);
      add_ramp(mesh, z, kNorthStrip, kWidth - 0.15);
      add_ramp(mesh, z, 0.15, kSouthStrip);
    }
    add_cars(mesh, z, random, 100 * static_cast<std::uint64_t>(storey));
  }
  mesh.add_box({0.15, 10.0, 0.0}, {3.0, 16.0, 3.0 * kStorey}, Material::kBrick);  // lift tower
  add_building(mesh, {-40.0, -10.0}, {-20.0, 40.0}, 4);
  add_building(mesh, {-10.0, 45.0}, {50.0, 60.0}, 3);
  add_building(mesh, {60.0, -20.0}, {75.0, 30.0}, 5);
  add_building(mesh, {0.0, -45.0}, {40.0, -25.0}, 2);

  const double up = 28.0;
  const double down = 2.0;
  const double s = kStorey;
  scene.route = {{5, 15, 0},
                 {5, up, 0},
                 {kRampFrom, up, 0},
                 {kRampTo, up, s},
                 {35, up, s},
                 {35, 14, s},
                 {5, 14, s},
                 {5, up, s},
                 {kRampFrom, up, s},
                 {kRampTo, up, 2 * s},
                 {35, up, 2 * s},
                 {35, down, 2 * s},
                 {kRampTo, down, 2 * s},
                 {kRampFrom, down, s},
                 {5, down, s},
                 {5, 12, s},
                 {35, 12, s},
                 {35, down, s},
                 {kRampTo, down, s},
                 {kRampFrom, down, 0},
                 {5, down, 0}};
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
