// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeBays = 231;

struct Measures {
  int rows;       ///< of bays; aisles run between them
  int bays;       ///< in a row
  double bay;     ///< along the row [m]
  double depth;   ///< of a bay [m]
  double aisle;   ///< between two rows [m]
  double height;  ///< of the hall [m]

  [[nodiscard]] double length() const { return bays * bay + 2.0 * aisle; }
  [[nodiscard]] double width() const { return rows * depth + (rows + 1) * aisle; }
  [[nodiscard]] double aisle_y(int number) const { return number * (depth + aisle) + 0.5 * aisle; }
};

Measures measures(const LayoutDraws& draw) {
  return {draw.whole(1, 3, 2, 4),         draw.whole(2, 8, 6, 10),
          draw.between(3, 5.0, 4.0, 6.0), draw.between(4, 4.0, 3.0, 5.0),
          draw.between(5, 3.6, 3.0, 4.5), draw.between(6, 4.2, 3.4, 5.5)};
}

/// One bay like the other: two walls of shelves and a column.
void add_bay(TriangleMesh& mesh, const Measures& m, double x, double y) {
  mesh.add_box({x, y, 0.0}, {x + 0.5, y + m.depth, 2.2}, Material::painted_metal);
  mesh.add_box({x + 0.5, y + 0.5 * m.depth - 0.2, 0.0}, {x + m.bay, y + 0.5 * m.depth + 0.2, 2.2},
               Material::painted_metal);
  mesh.add_column({x + 0.25, y, 0.0}, 0.2, m.height, Material::concrete, 8);
}

}  // namespace

/// Hall of shelves, bay beside bay; the way goes up and down its aisles.
Scene bays(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeBays);
  const Measures m = measures(draw);
  const CounterRandom random(seeds.things, kPurposeBays);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  const double l = m.length();
  const double w = m.width();
  for (const double z : {0.0, m.height}) {
    mesh.add_quad({0, 0, z}, {l, 0, z}, {l, w, z}, {0, w, z}, Material::concrete);
  }
  mesh.add_box({-0.2, 0, 0}, {0, w, m.height}, Material::brick);
  mesh.add_box({l, 0, 0}, {l + 0.2, w, m.height}, Material::brick);
  mesh.add_box({0, -0.2, 0}, {l, 0, m.height}, Material::brick);
  mesh.add_box({0, w, 0}, {l, w + 0.2, m.height}, Material::brick);
  for (int row = 0; row < m.rows; ++row) {
    const double y = m.aisle + row * (m.depth + m.aisle);
    for (int bay = 0; bay < m.bays; ++bay) add_bay(mesh, m, m.aisle + bay * m.bay, y);
    // All that tells one row from another: a few boxes on the floor.
    for (std::uint64_t box = 0; box < 3; ++box) {
      const std::uint64_t number = 10 * static_cast<std::uint64_t>(row) + 2 * box;
      const double x = m.aisle + 0.8 + random.uniform(number, 0.0, m.bays * m.bay - 2.0);
      const double size = random.uniform(number + 1, 0.4, 0.9);
      mesh.add_box({x, y + 0.1, 0.0}, {x + size, y + 0.1 + size, size}, Material::bark);
    }
  }
  const double west = 0.5 * m.aisle;
  const double east = l - 0.5 * m.aisle;
  scene.route.emplace_back(west, m.aisle_y(0), 0.0);
  for (int aisle = 0; aisle <= m.rows; ++aisle) {
    const bool out = aisle % 2 == 0;
    scene.route.emplace_back(out ? east : west, m.aisle_y(aisle), 0.0);
    if (aisle < m.rows) scene.route.emplace_back(out ? east : west, m.aisle_y(aisle + 1), 0.0);
  }
  if (m.rows % 2 == 0) scene.route.emplace_back(west, m.aisle_y(m.rows), 0.0);
  scene.corner_rounding = 0.5;
  scene.robot = "trot";
  scene.view_ceiling = m.height - 0.2;
  scene.view_margin = 4.0;
  return scene;
}

}  // namespace surefoot::simulation
