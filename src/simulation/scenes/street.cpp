// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeStreet = 230;
constexpr double kHouse = 8.0;  // both ways [m]

struct Measures {
  int houses;     ///< in a row
  double every;   ///< from one house to the next [m]
  double depth;   ///< of a block [m]
  double street;  ///< between the fronts [m]
  int storeys;

  [[nodiscard]] double row() const { return houses * every; }
  /// From the middle of a street to the middle of the next one, along y.
  [[nodiscard]] double block() const { return depth + street; }
};

Measures measures(const LayoutDraws& draw) {
  return {draw.whole(1, 5, 4, 6), draw.between(2, 11.0, 10.0, 13.0),
          draw.between(3, 20.0, 18.0, 24.0), draw.between(4, 9.0, 8.0, 11.0),
          draw.whole(5, 2, 1, 3)};
}

/// A row of houses, each like the others, with a hedge's post between two.
void add_row(TriangleMesh& mesh, const Measures& m, double low_y) {
  for (int house = 0; house < m.houses; ++house) {
    const double x = m.every * house + 0.5 * (m.every - kHouse);
    add_building(mesh, {x, low_y}, {x + kHouse, low_y + kHouse}, m.storeys);
    mesh.add_box({x - 0.8, low_y + 1.0, 0.0}, {x - 0.4, low_y + kHouse - 1.0, 1.1},
                 Material::foliage);
  }
}

/// What tells one house from another: who has parked in front.
void add_cars(TriangleMesh& mesh, const Measures& m, double y, const CounterRandom& random,
              std::uint64_t first) {
  const TriangleMesh car = make_car();
  for (int house = 0; house < m.houses; ++house) {
    const std::uint64_t draw = first + 4 * static_cast<std::uint64_t>(house);
    if (random.uniform(draw) < 0.75) continue;
    const double x = m.every * (house + 0.5) + random.uniform(draw + 1, -2.0, 2.0);
    mesh.add_mesh(placed(car, {x, y, 0.0}, random.uniform(draw + 2) < 0.5 ? 0.0 : 3.1416));
  }
}

}  // namespace

/// Two blocks of equal houses; the way is a figure eight round them.
Scene street(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeStreet);
  const Measures m = measures(draw);
  const CounterRandom random(seeds.things, kPurposeStreet);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  const double margin = 30.0;
  mesh.add_quad({-margin, -m.block() - margin, 0.0}, {m.row() + margin, -m.block() - margin, 0.0},
                {m.row() + margin, m.block() + margin, 0.0}, {-margin, m.block() + margin, 0.0},
                Material::asphalt);
  // Streets along x in the middle of -block, 0 and block; houses along both sides of each.
  for (int line = -1; line <= 1; ++line) {
    const double middle = m.block() * line;
    add_row(mesh, m, middle + 0.5 * m.street);
    add_row(mesh, m, middle - 0.5 * m.street - kHouse);
    const auto first = static_cast<std::uint64_t>(100 * (line + 2));
    add_cars(mesh, m, middle + 0.5 * m.street - 1.3, random, first);
    add_cars(mesh, m, middle - 0.5 * m.street + 1.3, random, first + 50);
  }
  const double west = -0.5 * m.street;
  const double east = m.row() + 0.5 * m.street;
  // Houses beyond the cross streets close the view.
  for (const double x : {west - 0.5 * m.street - kHouse, east + 0.5 * m.street}) {
    for (double y = -m.block() - 6.0; y < m.block(); y += m.every) {
      add_building(mesh, {x, y}, {x + kHouse, y + kHouse}, m.storeys);
    }
  }
  scene.route = {{0.3 * m.row(), 0.0, 0.0}, {east, 0.0, 0.0},        {east, m.block(), 0.0},
                 {west, m.block(), 0.0},    {west, 0.0, 0.0},        {0.5 * m.row(), -0.6, 0.0},
                 {east, -0.6, 0.0},         {east, -m.block(), 0.0}, {west, -m.block(), 0.0},
                 {west, -0.6, 0.0}};
  scene.corner_rounding = 0.8;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
