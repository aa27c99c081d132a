// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeStairwell = 203;
constexpr std::uint64_t kPurposeStoreys = 232;
constexpr double kDoor = -1.6;  // x of the wall between stairwell and hall [m]
constexpr double kSlab = 0.2;
constexpr double kEye = 0.1;  // half the gap between the flights

struct Measures {
  int floors;
  int steps;     ///< a flight; two flights a floor
  double tread;  ///< going of a step [m]
  double floor;  ///< height of a floor
  double half_width;
  double landing;   ///< depth of the landing between the flights
  double hall_end;  ///< x
  double hall_half;

  [[nodiscard]] double rise() const { return floor / (2 * steps); }
  [[nodiscard]] double flight() const { return steps * tread; }
  [[nodiscard]] double landing_end() const { return flight() + landing; }
  /// y of the middle of a flight.
  [[nodiscard]] double lane() const { return 0.5 * (half_width + kEye); }
};

Measures measures(const LayoutDraws& draw) {
  constexpr double kLowestFloor = 2.75;  // a door and its lintel
  Measures m{};
  m.floors = draw.whole(1, 4, 3, 5);
  m.steps = draw.whole(2, 9, 8, 11);
  m.tread = draw.between(3, 0.29, 0.265, 0.32);
  m.floor = draw.between(4, 3.2, std::max(kLowestFloor, 0.150 * 2 * m.steps), 0.185 * 2 * m.steps);
  m.half_width = draw.between(5, 1.4, 1.25, 1.7);
  m.landing = draw.between(6, 1.6, 1.5, 2.1);
  m.hall_end = draw.between(7, -9.6, -12.5, -9.2);
  m.hall_half = draw.between(8, 4.2, 3.7, 5.2);
  return m;
}

/// Steps from x = from, one tread each towards `direction`, between two y.
void add_flight(TriangleMesh& mesh, const Measures& m, double from, double direction, double y0,
                double y1, double bottom) {
  for (int step = 0; step < m.steps; ++step) {
    const double near = from + direction * m.tread * step;
    const double far = near + direction * m.tread;
    const double low = bottom + m.rise() * step;
    const double high = low + m.rise();
    mesh.add_quad({near, y0, low}, {near, y1, low}, {near, y1, high}, {near, y0, high},
                  Material::concrete);
    mesh.add_quad({near, y0, high}, {near, y1, high}, {far, y1, high}, {far, y0, high},
                  Material::concrete);
  }
  const double end = from + direction * m.flight();
  const double top = bottom + m.rise() * m.steps;
  mesh.add_quad({from, y0, bottom - kSlab}, {from, y1, bottom - kSlab}, {end, y1, top - kSlab},
                {end, y0, top - kSlab}, Material::concrete);
}

/// Balusters and hand rail along the eye of the stairs.
void add_rail(TriangleMesh& mesh, const Measures& m, double from, double direction, double y,
              double bottom) {
  for (int step = 0; step < m.steps; step += 2) {
    const double x = from + direction * m.tread * (step + 0.5);
    mesh.add_column({x, y, bottom + m.rise() * (step + 1)}, 0.02, 0.9, Material::painted_metal, 6);
  }
  const double end = from + direction * m.flight();
  const double top = bottom + m.rise() * m.steps;
  mesh.add_quad({from, y, bottom + 1.0}, {end, y, top + 1.0}, {end, y, top + 1.06},
                {from, y, bottom + 1.06}, Material::painted_metal);
}

void add_hall(TriangleMesh& mesh, const Measures& m, double z, const CounterRandom& random,
              std::uint64_t floor) {
  const double top = z + m.floor - kSlab;
  mesh.add_box({m.hall_end, -m.hall_half, z - kSlab}, {kDoor, m.hall_half, z}, Material::concrete);
  mesh.add_box({m.hall_end - 0.2, -m.hall_half, z}, {m.hall_end, m.hall_half, top},
               Material::brick);
  mesh.add_box({m.hall_end, -m.hall_half - 0.2, z}, {kDoor, -m.hall_half, top}, Material::brick);
  mesh.add_box({m.hall_end, m.hall_half, z}, {kDoor, m.hall_half + 0.2, top}, Material::brick);
  // The wall towards the stairs leaves the whole stairwell open as a door, with a lintel.
  mesh.add_box({kDoor - 0.15, -m.hall_half, z}, {kDoor, -m.half_width + 0.2, top}, Material::brick);
  mesh.add_box({kDoor - 0.15, m.half_width - 0.2, z}, {kDoor, m.hall_half, top}, Material::brick);
  mesh.add_box({kDoor - 0.15, -m.half_width, z + 2.3}, {kDoor, m.half_width, top}, Material::brick);
  const double shelf = random.uniform(floor, -8.8, -4.0);
  mesh.add_box({shelf, m.hall_half - 0.4, z}, {shelf + 1.6, m.hall_half, z + 1.9}, Material::bark);
  add_bench(mesh, {random.uniform(floor + 16, -8.0, -4.0), -m.hall_half + 0.4, z}, 3.1416);
  mesh.add_column({-5.6, 0.0, z}, 0.2, m.floor - kSlab, Material::concrete, 12);
}

void add_stairs(TriangleMesh& mesh, const Measures& m, double z) {
  const double middle = z + 0.5 * m.floor;
  add_flight(mesh, m, 0.0, 1.0, -m.half_width, -kEye, z);
  add_rail(mesh, m, 0.0, 1.0, -kEye, z);
  mesh.add_box({m.flight(), -m.half_width, middle - kSlab}, {m.landing_end(), m.half_width, middle},
               Material::concrete);
  add_flight(mesh, m, m.flight(), -1.0, kEye, m.half_width, middle);
  add_rail(mesh, m, m.flight(), -1.0, kEye, middle);
}

/// The building with its halls and stairs. `alike`: every storey has the same furniture.
Scene building(const SceneSeeds& seeds, const Measures& m, bool alike) {
  const CounterRandom random(seeds.things, kPurposeStairwell);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  const double top = m.floor * m.floors;
  for (int floor = 0; floor < m.floors; ++floor) {
    const double z = m.floor * floor;
    add_hall(mesh, m, z, random, alike ? 0 : static_cast<std::uint64_t>(floor));
    mesh.add_box({kDoor, -m.half_width, z - kSlab}, {0.0, m.half_width, z}, Material::concrete);
    if (floor + 1 < m.floors) add_stairs(mesh, m, z);
  }
  mesh.add_box({0.0, -m.half_width, -kSlab}, {m.landing_end(), m.half_width, 0.0},
               Material::concrete);
  mesh.add_box({kDoor, m.half_width, 0.0}, {m.landing_end(), m.half_width + 0.2, top},
               Material::brick);
  mesh.add_box({kDoor, -m.half_width - 0.2, 0.0}, {m.landing_end(), -m.half_width, top},
               Material::brick);
  mesh.add_box({m.landing_end(), -m.half_width, 0.0}, {m.landing_end() + 0.2, m.half_width, top},
               Material::brick);
  mesh.add_box({m.hall_end, -m.hall_half, top}, {m.landing_end(), m.hall_half, top + kSlab},
               Material::concrete);
  scene.corner_rounding = 0.25;
  scene.robot = "stairs";
  scene.view_ceiling = top - kSlab - 0.3;
  scene.view_front = 0.05;
  scene.view_margin = 3.0;
  return scene;
}

using Way = std::vector<Eigen::Vector3d>;

/// From one storey to the next, or back.
void append_flights(Way& route, const Measures& m, double z, bool up) {
  Way way = {{-0.7, -m.lane(), z},
             {0.0, -m.lane(), z},
             {m.flight(), -m.lane(), z + 0.5 * m.floor},
             {m.flight() + 0.8, -m.lane(), z + 0.5 * m.floor},
             {m.flight() + 0.8, m.lane(), z + 0.5 * m.floor},
             {m.flight(), m.lane(), z + 0.5 * m.floor},
             {0.0, m.lane(), z + m.floor},
             {-0.7, m.lane(), z + m.floor}};
  if (!up) way = {way.rbegin(), way.rend()};
  route.insert(route.end(), way.begin(), way.end());
}

}  // namespace

Scene stairwell(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeStairwell);
  const Measures m = measures(draw);
  Scene scene = building(seeds, m, false);
  // Round the column of the hall, clear of its furniture.
  const double far = draw.first() ? -7.6 : m.hall_end + 2.0;
  const double aside = 1.8;
  // Up on the way out, down on the way back, a turn round the column of the hall at both ends.
  scene.route = {{-3.0, aside, 0.0},
                 {far, aside, 0.0},
                 {far, -aside, 0.0},
                 {-3.0, -aside, 0.0},
                 {-2.2, -m.lane(), 0.0}};
  for (int floor = 0; floor + 1 < m.floors; ++floor) {
    append_flights(scene.route, m, m.floor * floor, true);
  }
  const double roof_floor = m.floor * (m.floors - 1);
  for (const auto& [x, y] :
       {std::pair{-2.2, 0.6}, {-3.0, aside}, {far, aside}, {far, -aside}, {-3.0, -aside}}) {
    scene.route.emplace_back(x, y, roof_floor);
  }
  scene.route.emplace_back(-1.6, 0.0, roof_floor);
  for (int floor = m.floors - 2; floor >= 0; --floor) {
    append_flights(scene.route, m, m.floor * floor, false);
  }
  scene.route.emplace_back(-1.6, 0.0, 0.0);
  return scene;
}

/// Up through storeys that look alike, round the hall of each, and down again the other way round.
Scene storeys(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeStoreys);
  Measures m = measures(draw);
  m.floors = 4;
  m.hall_end -= 6.0;
  Scene scene = building(seeds, m, true);
  const double far = m.hall_end + 2.0;
  const double aside = 1.8;
  Way round = {{-2.2, 0.6, 0.0},   {-3.0, aside, 0.0},  {far, aside, 0.0},
               {far, -aside, 0.0}, {-3.0, -aside, 0.0}, {-2.2, -m.lane(), 0.0}};
  const auto append_round = [&](double z, bool up) {
    const Way way = up ? round : Way(round.rbegin(), round.rend());
    for (const Eigen::Vector3d& corner : way) {
      scene.route.emplace_back(corner.x(), corner.y(), z);
    }
  };
  for (int floor = 0; floor + 1 < m.floors; ++floor) {
    append_round(m.floor * floor, true);
    append_flights(scene.route, m, m.floor * floor, true);
  }
  round.back() = {-1.6, 0.0, 0.0};
  append_round(m.floor * (m.floors - 1), true);
  round.back() = {-2.2, -m.lane(), 0.0};
  for (int floor = m.floors - 2; floor >= 0; --floor) {
    append_flights(scene.route, m, m.floor * floor, false);
    append_round(m.floor * floor, false);
  }
  return scene;
}

}  // namespace surefoot::simulation
