// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <array>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeParking = 202;
constexpr double kSlab = 0.25;       // [m]
constexpr double kRampFrom = 10.0;   // x where a ramp begins to rise by one storey
constexpr double kSouthStrip = 4.0;  // ramps down lie in y < 4

struct Measures {
  int storeys;
  double storey;   ///< height [m]
  double ramp_to;  ///< x where a ramp has risen by one storey
  double length;   ///< x
  double width;    ///< y

  [[nodiscard]] double north_strip() const { return width - 4.0; }  ///< ramps up lie beyond
  [[nodiscard]] double middle() const { return 0.5 * width; }
};

Measures measures(const LayoutDraws& draw) {
  Measures m{};
  m.storeys = draw.whole(1, 3, 2, 4);
  m.storey = draw.between(2, 3.0, 2.7, 3.4);
  // Between 1 : 7.5 and 1 : 5.2, so 7.6 to 10.9 deg; the first has 9.5 deg.
  m.ramp_to = kRampFrom + draw.between(3, 18.0, 5.2 * m.storey, 7.5 * m.storey);
  m.length = m.ramp_to + draw.between(4, 12.0, 9.0, 15.0);
  m.width = draw.between(5, 30.0, 27.0, 38.0);
  return m;
}

void add_slab(TriangleMesh& mesh, const Measures& m, double z) {
  const auto plate = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, z - kSlab}, {x1, y1, z}, Material::concrete);
  };
  plate(0.0, 0.0, kRampFrom, m.width);
  plate(m.ramp_to, 0.0, m.length, m.width);
  plate(kRampFrom, kSouthStrip, m.ramp_to, m.north_strip());
}

/// Ramp from `bottom` up by one storey in the strip between two y; towards x in both strips.
void add_ramp(TriangleMesh& mesh, const Measures& m, double bottom, double y0, double y1) {
  const double top = bottom + m.storey;
  mesh.add_quad({kRampFrom, y0, bottom}, {m.ramp_to, y0, top}, {m.ramp_to, y1, top},
                {kRampFrom, y1, bottom}, Material::concrete);
  mesh.add_quad({kRampFrom, y0, bottom - kSlab}, {m.ramp_to, y0, top - kSlab},
                {m.ramp_to, y1, top - kSlab}, {kRampFrom, y1, bottom - kSlab}, Material::concrete);
}

void add_parapets(TriangleMesh& mesh, const Measures& m, double z, bool over_ramps) {
  const auto wall = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, z}, {x1, y1, z + 1.0}, Material::concrete);
  };
  wall(0.0, 0.0, m.length, 0.15);
  wall(0.0, m.width - 0.15, m.length, m.width);
  wall(0.0, 0.15, 0.15, m.width - 0.15);
  wall(m.length - 0.15, 0.15, m.length, m.width - 0.15);
  if (!over_ramps) return;
  wall(kRampFrom, kSouthStrip, m.ramp_to, kSouthStrip + 0.15);
  wall(kRampFrom, m.north_strip() - 0.15, m.ramp_to, m.north_strip());
}

void add_columns(TriangleMesh& mesh, const Measures& m, double z) {
  for (double x = 8.0; x <= m.length - 8.0; x += 8.0) {
    for (const double y : {m.middle() - 7.5, m.middle() + 7.5}) {
      mesh.add_box({x - 0.25, y - 0.25, z}, {x + 0.25, y + 0.25, z + m.storey - kSlab},
                   Material::concrete);
    }
  }
}

void add_cars(TriangleMesh& mesh, const Measures& m, double z, const CounterRandom& random,
              std::uint64_t first) {
  const TriangleMesh car = make_car();
  std::uint64_t bay = first;
  for (double x = 10.5; x < m.length - 9.0; x += 2.7, ++bay) {
    for (const double y : {m.middle() + 4.5, m.middle() - 6.5}) {
      const std::uint64_t draw = 4 * bay + (y > m.middle() ? 2 : 0);
      if (random.uniform(draw) < 0.35) continue;
      mesh.add_mesh(placed(car, {x, y, z}, 1.5708 + random.uniform(draw + 1, -0.05, 0.05)));
    }
  }
}

}  // namespace

Scene parking(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeParking);
  const Measures m = measures(draw);
  const CounterRandom random(seeds.things, kPurposeParking);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_quad({-60, -60, -0.001}, {100, -60, -0.001}, {100, 90, -0.001}, {-60, 90, -0.001},
                Material::asphalt);
  for (int storey = 0; storey < m.storeys; ++storey) {
    const double z = m.storey * storey;
    if (storey > 0) add_slab(mesh, m, z);
    add_parapets(mesh, m, z, storey > 0);
    if (storey + 1 < m.storeys) {
      add_columns(mesh, m, z);
      add_ramp(mesh, m, z, m.north_strip(), m.width - 0.15);
      add_ramp(mesh, m, z, 0.15, kSouthStrip);
    }
    add_cars(mesh, m, z, random, 100 * static_cast<std::uint64_t>(storey));
  }
  mesh.add_box({0.15, 10.0, 0.0}, {3.0, 16.0, m.storeys * m.storey},
               Material::brick);  // lift tower
  add_building(mesh, {-40.0, -10.0}, {draw.between(8, -20.0, -28.0, -14.0), 40.0}, 4);
  add_building(mesh, {-10.0, m.width + 15.0}, {50.0, m.width + 30.0}, draw.whole(6, 3, 1, 6));
  add_building(mesh, {m.length + 20.0, -20.0}, {m.length + 35.0, 30.0}, draw.whole(7, 5, 1, 6));
  add_building(mesh, {0.0, -45.0}, {40.0, draw.between(9, -25.0, -32.0, -15.0)}, 2);

  const double up = m.width - 2.0;
  const double down = 2.0;
  const double west = 5.0;
  const double east = m.length - 5.0;
  const double top = m.storey * (m.storeys - 1);
  scene.route = {{west, m.middle(), 0}, {west, up, 0}};
  for (int storey = 0; storey + 1 < m.storeys; ++storey) {
    const double z = m.storey * storey;
    const double next = m.storey * (storey + 1);
    scene.route.insert(scene.route.end(),
                       {{kRampFrom, up, z}, {m.ramp_to, up, next}, {east, up, next}});
    if (storey + 2 == m.storeys) break;
    const double aisle = m.middle() - 1.0;
    scene.route.insert(scene.route.end(),
                       {{east, aisle, next}, {west, aisle, next}, {west, up, next}});
  }
  scene.route.emplace_back(east, down, top);
  for (int storey = m.storeys - 1; storey > 0; --storey) {
    const double z = m.storey * storey;
    const double next = m.storey * (storey - 1);
    scene.route.insert(scene.route.end(),
                       {{m.ramp_to, down, z}, {kRampFrom, down, next}, {west, down, next}});
    if (storey == 1) break;
    const double aisle = m.middle() - 3.0;
    scene.route.insert(scene.route.end(),
                       {{west, aisle, next}, {east, aisle, next}, {east, down, next}});
  }
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
