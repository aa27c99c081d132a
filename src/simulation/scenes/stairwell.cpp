// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeStairwell = 203;
constexpr int kFloors = 4;
constexpr int kSteps = 9;        // a flight
constexpr double kTread = 0.29;  // [m]
constexpr double kRise = 3.2 / (2 * kSteps);
constexpr double kFlight = kSteps * kTread;
constexpr double kFloor = 3.2;
constexpr double kHalfWidth = 1.4;  // of the stairwell
constexpr double kLandingEnd = kFlight + 1.6;
constexpr double kDoor = -1.6;  // x of the wall between stairwell and hall
constexpr double kHallEnd = -9.6;
constexpr double kHallHalf = 4.2;
constexpr double kSlab = 0.2;

/// Steps from x = from, one tread each towards `direction`, between two y.
void add_flight(TriangleMesh& mesh, double from, double direction, double y0, double y1,
                double bottom) {
  for (int step = 0; step < kSteps; ++step) {
    const double near = from + direction * kTread * step;
    const double far = near + direction * kTread;
    const double low = bottom + kRise * step;
    const double high = low + kRise;
    mesh.add_quad({near, y0, low}, {near, y1, low}, {near, y1, high}, {near, y0, high},
                  Material::kConcrete);
    mesh.add_quad({near, y0, high}, {near, y1, high}, {far, y1, high}, {far, y0, high},
                  Material::kConcrete);
  }
  const double end = from + direction * kFlight;
  const double top = bottom + kRise * kSteps;
  mesh.add_quad({from, y0, bottom - kSlab}, {from, y1, bottom - kSlab}, {end, y1, top - kSlab},
                {end, y0, top - kSlab}, Material::kConcrete);
}

/// Balusters and hand rail along the eye of the stairs.
void add_rail(TriangleMesh& mesh, double from, double direction, double y, double bottom) {
  for (int step = 0; step < kSteps; step += 2) {
    const double x = from + direction * kTread * (step + 0.5);
    mesh.add_column({x, y, bottom + kRise * (step + 1)}, 0.02, 0.9, Material::kPaintedMetal, 6);
  }
  const double end = from + direction * kFlight;
  const double top = bottom + kRise * kSteps;
  mesh.add_quad({from, y, bottom + 1.0}, {end, y, top + 1.0}, {end, y, top + 1.06},
                {from, y, bottom + 1.06}, Material::kPaintedMetal);
}

void add_hall(TriangleMesh& mesh, double z, const CounterRandom& random, std::uint64_t floor) {
  const double top = z + kFloor - kSlab;
  mesh.add_box({kHallEnd, -kHallHalf, z - kSlab}, {kDoor, kHallHalf, z}, Material::kConcrete);
  mesh.add_box({kHallEnd - 0.2, -kHallHalf, z}, {kHallEnd, kHallHalf, top}, Material::kBrick);
  mesh.add_box({kHallEnd, -kHallHalf - 0.2, z}, {kDoor, -kHallHalf, top}, Material::kBrick);
  mesh.add_box({kHallEnd, kHallHalf, z}, {kDoor, kHallHalf + 0.2, top}, Material::kBrick);
  // The wall towards the stairs leaves the whole stairwell open as a door, with a lintel.
  mesh.add_box({kDoor - 0.15, -kHallHalf, z}, {kDoor, -kHalfWidth + 0.2, top}, Material::kBrick);
  mesh.add_box({kDoor - 0.15, kHalfWidth - 0.2, z}, {kDoor, kHallHalf, top}, Material::kBrick);
  mesh.add_box({kDoor - 0.15, -kHalfWidth, z + 2.3}, {kDoor, kHalfWidth, top}, Material::kBrick);
  const double shelf = random.uniform(floor, -8.8, -4.0);
  mesh.add_box({shelf, kHallHalf - 0.4, z}, {shelf + 1.6, kHallHalf, z + 1.9}, Material::kBark);
  add_bench(mesh, {random.uniform(floor + 16, -8.0, -4.0), -kHallHalf + 0.4, z}, 3.1416);
  mesh.add_column({-5.6, 0.0, z}, 0.2, kFloor - kSlab, Material::kConcrete, 12);
}

void add_stairs(TriangleMesh& mesh, double z) {
  const double middle = z + 0.5 * kFloor;
  add_flight(mesh, 0.0, 1.0, -kHalfWidth, -0.1, z);
  add_rail(mesh, 0.0, 1.0, -0.1, z);
  mesh.add_box({kFlight, -kHalfWidth, middle - kSlab}, {kLandingEnd, kHalfWidth, middle},
               Material::kConcrete);
  add_flight(mesh, kFlight, -1.0, 0.1, kHalfWidth, middle);
  add_rail(mesh, kFlight, -1.0, 0.1, middle);
}

}  // namespace

Scene stairwell(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposeStairwell);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  const double top = kFloor * kFloors;
  for (int floor = 0; floor < kFloors; ++floor) {
    const double z = kFloor * floor;
    add_hall(mesh, z, random, static_cast<std::uint64_t>(floor));
    mesh.add_box({kDoor, -kHalfWidth, z - kSlab}, {0.0, kHalfWidth, z}, Material::kConcrete);
    if (floor + 1 < kFloors) add_stairs(mesh, z);
  }
  mesh.add_box({0.0, -kHalfWidth, -kSlab}, {kLandingEnd, kHalfWidth, 0.0}, Material::kConcrete);
  mesh.add_box({kDoor, kHalfWidth, 0.0}, {kLandingEnd, kHalfWidth + 0.2, top}, Material::kBrick);
  mesh.add_box({kDoor, -kHalfWidth - 0.2, 0.0}, {kLandingEnd, -kHalfWidth, top}, Material::kBrick);
  mesh.add_box({kLandingEnd, -kHalfWidth, 0.0}, {kLandingEnd + 0.2, kHalfWidth, top},
               Material::kBrick);
  mesh.add_box({kHallEnd, -kHallHalf, top}, {kLandingEnd, kHallHalf, top + kSlab},
               Material::kConcrete);

  // Up on the way out, down on the way back, a turn round the column of the hall at both ends.
  const auto flight_way = [&](double z, bool up) {
    std::vector<Eigen::Vector3d> way = {{-0.7, -0.75, z},
                                        {0.0, -0.75, z},
                                        {kFlight, -0.75, z + 0.5 * kFloor},
                                        {kFlight + 0.8, -0.75, z + 0.5 * kFloor},
                                        {kFlight + 0.8, 0.75, z + 0.5 * kFloor},
                                        {kFlight, 0.75, z + 0.5 * kFloor},
                                        {0.0, 0.75, z + kFloor},
                                        {-0.7, 0.75, z + kFloor}};
    if (!up) way = {way.rbegin(), way.rend()};
    scene.route.insert(scene.route.end(), way.begin(), way.end());
  };
  scene.route = {
      {-3.0, 1.8, 0.0}, {-7.6, 1.8, 0.0}, {-7.6, -1.8, 0.0}, {-3.0, -1.8, 0.0}, {-2.2, -0.75, 0.0}};
  for (int floor = 0; floor + 1 < kFloors; ++floor) flight_way(kFloor * floor, true);
  const double roof_floor = kFloor * (kFloors - 1);
  for (const auto& [x, y] :
       {std::pair{-2.2, 0.6}, {-3.0, 1.8}, {-7.6, 1.8}, {-7.6, -1.8}, {-3.0, -1.8}}) {
    scene.route.emplace_back(x, y, roof_floor);
  }
  scene.route.emplace_back(-1.6, 0.0, roof_floor);
  for (int floor = kFloors - 2; floor >= 0; --floor) flight_way(kFloor * floor, false);
  scene.route.emplace_back(-1.6, 0.0, 0.0);
  scene.corner_rounding = 0.25;
  scene.robot = "stairs";
  scene.view_ceiling = top - kSlab - 0.3;
  scene.view_front = 0.05;
  scene.view_margin = 3.0;
  return scene;
}

}  // namespace surefoot::simulation
