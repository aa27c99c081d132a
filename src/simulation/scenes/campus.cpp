// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeCampus = 201;
constexpr double kTerraceHeight = 2.0;  // [m]
constexpr double kRampStart = 4.0;      // x [m]; both ramps rise from here ...
constexpr double kRampEnd = 19.0;       // ... to here: 7.6 deg
constexpr double kRampHalfWidth = 1.5;
constexpr double kSouthRamp = 0.0;  // y of the ramps' centre lines
constexpr double kNorthRamp = 14.0;
constexpr double kTerraceFar = 40.0;
constexpr double kCampusHalf = 90.0;

/// Meadows and paths are never quite even.
double meadow(double x, double y) {
  return 0.03 * std::sin(0.31 * x + 0.4) * std::cos(0.27 * y) + 0.015 * std::sin(0.9 * x + 0.7 * y);
}

void add_ramp(TriangleMesh& mesh, double centre_y) {
  const double low = centre_y - kRampHalfWidth;
  const double high = centre_y + kRampHalfWidth;
  // The foot reaches a little below the meadow, so that there is no gap to fall through.
  const Eigen::Vector3d foot_low(kRampStart - 0.5, low, -kTerraceHeight / 30.0);
  const Eigen::Vector3d foot_high(kRampStart - 0.5, high, -kTerraceHeight / 30.0);
  const Eigen::Vector3d top_low(kRampEnd, low, kTerraceHeight);
  const Eigen::Vector3d top_high(kRampEnd, high, kTerraceHeight);
  mesh.add_quad(foot_low, top_low, top_high, foot_high, Material::kConcrete);
  for (const double side : {low, high}) {
    mesh.add_quad({kRampStart - 0.5, side, -0.2}, {kRampEnd, side, -0.2},
                  {kRampEnd, side, kTerraceHeight}, {kRampStart - 0.5, side, 0.0},
                  Material::kConcrete);
    // Railing: posts and a hand rail.
    for (double x = kRampStart; x < kRampEnd; x += 1.5) {
      const double z = kTerraceHeight * (x - kRampStart) / (kRampEnd - kRampStart);
      mesh.add_column({x, side, z}, 0.025, 0.95, Material::kPaintedMetal, 6);
    }
    mesh.add_quad({kRampStart, side, 0.90}, {kRampEnd, side, kTerraceHeight + 0.90},
                  {kRampEnd, side, kTerraceHeight + 0.96}, {kRampStart, side, 0.96},
                  Material::kPaintedMetal);
  }
}

void add_terrace(TriangleMesh& mesh) {
  const double south = kSouthRamp - kRampHalfWidth - 2.0;
  const double north = kNorthRamp + kRampHalfWidth + 2.0;
  mesh.add_box({kRampEnd, south, -0.3}, {kTerraceFar, north, kTerraceHeight}, Material::kConcrete);
  const double top = kTerraceHeight + 0.9;
  const auto parapet = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, kTerraceHeight}, {x1, y1, top}, Material::kConcrete);
  };
  parapet(kRampEnd, south, kTerraceFar, south + 0.2);
  parapet(kRampEnd, north - 0.2, kTerraceFar, north);
  parapet(kTerraceFar - 0.2, south, kTerraceFar, north);
  // Towards the ramps the parapet leaves two openings.
  parapet(kRampEnd, south, kRampEnd + 0.2, kSouthRamp - kRampHalfWidth);
  parapet(kRampEnd, kSouthRamp + kRampHalfWidth, kRampEnd + 0.2, kNorthRamp - kRampHalfWidth);
  parapet(kRampEnd, kNorthRamp + kRampHalfWidth, kRampEnd + 0.2, north);
  // A pavilion of columns in the middle of the terrace.
  for (double x = 23.0; x <= 33.0; x += 2.5) {
    for (const double y : {5.0, 9.0}) {
      mesh.add_column({x, y, kTerraceHeight}, 0.2, 3.0, Material::kConcrete, 12);
    }
  }
  mesh.add_box({22.0, 4.0, kTerraceHeight + 3.0}, {34.0, 10.0, kTerraceHeight + 3.3},
               Material::kConcrete);
  for (const double y : {-2.6, 16.6}) {
    for (double x = 22.0; x < 38.0; x += 4.0) {
      mesh.add_box({x, y - 0.35, kTerraceHeight}, {x + 1.4, y + 0.35, kTerraceHeight + 0.55},
                   Material::kBrick);
    }
  }
}

void add_surroundings(TriangleMesh& mesh, const CounterRandom& random) {
  add_building(mesh, {-30.0, 24.0}, {6.0, 38.0}, 4);
  add_building(mesh, {12.0, 28.0}, {48.0, 42.0}, 3);
  add_building(mesh, {50.0, -10.0}, {66.0, 22.0}, 5);
  add_building(mesh, {-14.0, -34.0}, {20.0, -18.0}, 3);
  add_building(mesh, {28.0, -36.0}, {46.0, -20.0}, 6);
  add_building(mesh, {-52.0, -20.0}, {-34.0, 14.0}, 4);
  add_building(mesh, {7.0, 4.0}, {15.0, 10.0}, 1);  // kiosk between the ramps
  std::uint64_t tree = 0;
  const auto plant = [&](double x, double y) {
    const double dx = random.uniform(4 * tree + 1'000'000, -0.8, 0.8);
    const double dy = random.uniform(4 * tree + 1'000'001, -0.8, 0.8);
    const double height = random.uniform(4 * tree + 1'000'002, 4.5, 9.0);
    add_tree(mesh, {x + dx, y + dy, meadow(x + dx, y + dy)}, height, random, tree);
    ++tree;
  };
  for (double x = -26.0; x < 46.0; x += 9.0) plant(x, -11.0);
  for (double x = -26.0; x < 46.0; x += 10.0) plant(x, 21.0);
  for (double y = -14.0; y < 20.0; y += 8.0) plant(-18.0, y);
  for (double y = -30.0; y < 40.0; y += 11.0) plant(74.0, y);
  for (double x = -60.0; x < 70.0; x += 12.0) plant(x, 56.0);
  for (double x = -60.0; x < 70.0; x += 12.0) plant(x, -52.0);
  for (double x = -8.0; x < 40.0; x += 12.0) add_lamp(mesh, {x, -5.5, meadow(x, -5.5)});
  for (double y = 2.0; y < 16.0; y += 5.0) add_bench(mesh, {-7.0, y, meadow(-7.0, y)}, 1.5708);
  const TriangleMesh car = make_car();
  for (double x = -20.0; x < 40.0; x += 3.1) {
    if (random.uniform(static_cast<std::uint64_t>(x + 100.0) + 2'000'000) < 0.35) continue;
    mesh.add_mesh(placed(car, {x, -15.0, 0.0}, 1.5708));
  }
}

}  // namespace

Scene campus(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposeCampus);
  Scene scene;
  scene.mesh.add_heightfield({-kCampusHalf, -kCampusHalf}, {kCampusHalf, kCampusHalf}, 0.75, meadow,
                             Material::kGrass);
  add_ramp(scene.mesh, kSouthRamp);
  add_ramp(scene.mesh, kNorthRamp);
  add_terrace(scene.mesh);
  add_surroundings(scene.mesh, random);
  const double t = kTerraceHeight;
  scene.route = {
      {-2.0, 7.0, 0.0},          {-2.0, kSouthRamp, 0.0},       {kRampStart, kSouthRamp, 0.0},
      {kRampEnd, kSouthRamp, t}, {36.5, kSouthRamp, t},         {36.5, kNorthRamp, t},
      {kRampEnd, kNorthRamp, t}, {kRampStart, kNorthRamp, 0.0}, {-2.0, kNorthRamp, 0.0}};
  scene.corner_rounding = 0.7;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
