// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "town.hpp"

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "simulation/random.hpp"
#include "simulation/scenes/furniture.hpp"
#include "simulation/triangle_mesh.hpp"

namespace surefoot::benchmarks {

namespace {

using simulation::Material;
using simulation::TriangleMesh;

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kPurposeTown = 301;
constexpr double kLength = 400.0;  // of the block, between the streets' middles [m]
constexpr double kWidth = 250.0;
constexpr double kMargin = 60.0;  // ground beyond the streets
constexpr double kHouse = 20.0;
constexpr double kAlley = 4.0;
constexpr double kHouseFront = 8.0;  // from the street's middle
constexpr double kHouseBack = 20.0;
constexpr double kKerb = 5.0;  // where trees stand and cars park

/// Asphalt is never quite even.
double ground(double x, double y) {
  return 0.03 * std::sin(0.23 * x + 0.4) * std::cos(0.19 * y) + 0.01 * std::sin(0.8 * x + 0.6 * y);
}

Eigen::Vector3d on_ground(const Eigen::Vector2d& place) {
  return {place.x(), place.y(), ground(place.x(), place.y())};
}

/// Houses of several heights on both sides, with trees, cars and lamps before them. `number` picks
/// the street's own random draws.
void add_street(TriangleMesh& mesh, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                std::uint64_t number) {
  const simulation::CounterRandom random(kSeed, kPurposeTown + number);
  const TriangleMesh car = simulation::make_car();
  const double length = (to - from).norm();
  const Eigen::Vector2d along = (to - from) / length;
  const Eigen::Vector2d left(-along.y(), along.x());
  const double heading = std::atan2(along.y(), along.x());
  std::uint64_t house = 0;
  for (double start = kHouseBack; start + kHouse < length - kHouseBack; start += kHouse + kAlley) {
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double distance, double aside) -> Eigen::Vector2d {
        return from + (start + distance) * along + side * aside * left;
      };
      const std::uint64_t draw = 8 * house;
      const Eigen::Vector2d front = at(0.0, kHouseFront + random.uniform(draw, -0.8, 0.8));
      const Eigen::Vector2d back = at(kHouse, kHouseBack);
      const int storeys = 2 + static_cast<int>(random.uniform(draw + 1, 0.0, 4.0));
      add_building(mesh, front.cwiseMin(back), front.cwiseMax(back), storeys);
      const double shift = random.uniform(draw + 2, 0.0, 4.0);
      add_tree(mesh, on_ground(at(2.0 + shift, kKerb)), random.uniform(draw + 3, 4.5, 8.0), random,
               1'000 + house);
      mesh.add_mesh(placed(car, on_ground(at(10.0 + shift, kKerb - 0.5)), heading));
      add_lamp(mesh, on_ground(at(18.0, kKerb + 1.0)));
      ++house;
    }
  }
}

}  // namespace

simulation::Scene town() {
  const Eigen::Vector2d corners[] = {{0.0, 0.0}, {kLength, 0.0}, {kLength, kWidth}, {0.0, kWidth}};
  simulation::Scene scene;
  scene.name = "town";
  scene.description = "four streets around a block";
  scene.mesh.add_heightfield({-kMargin, -kMargin}, {kLength + kMargin, kWidth + kMargin}, 2.0,
                             ground, Material::asphalt);
  for (std::uint64_t i = 0; i < 4; ++i) {
    add_street(scene.mesh, corners[i], corners[(i + 1) % 4], i);
    scene.route.push_back(on_ground(corners[i]));
  }
  scene.corner_rounding = 2.0;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::benchmarks
