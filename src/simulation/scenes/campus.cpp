// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeCampus = 201;
constexpr double kRampStart = 4.0;  // x where both ramps rise from [m]
constexpr double kSouthRamp = 0.0;  // y of the southern ramp's centre line
constexpr double kCampusHalf = 90.0;

struct Measures {
  double height;    ///< of the terrace [m]
  double ramp_end;  ///< x
  double ramp_half_width;
  double north_ramp;   ///< y of the northern ramp's centre line
  double terrace_far;  ///< x
  double start;        ///< x of the way between the ramps, on the meadow
};

Measures measures(const LayoutDraws& draw) {
  Measures m{};
  m.height = draw.between(1, 2.0, 1.4, 2.6);
  // Between 1 : 10 and 1 : 5.5, so 5.7 to 10.3 deg; the first has 7.6 deg.
  m.ramp_end = kRampStart + draw.between(2, 15.0, 5.5 * m.height, 10.0 * m.height);
  m.ramp_half_width = draw.between(3, 1.5, 1.1, 2.0);
  m.north_ramp = draw.between(4, 14.0, 11.5, 18.0);
  m.terrace_far = m.ramp_end + draw.between(5, 21.0, 20.0, 26.0);
  m.start = draw.between(6, -2.0, -6.0, -1.5);
  return m;
}

/// Meadows and paths are never quite even.
double meadow(double x, double y) {
  return 0.03 * std::sin(0.31 * x + 0.4) * std::cos(0.27 * y) + 0.015 * std::sin(0.9 * x + 0.7 * y);
}

void add_ramp(TriangleMesh& mesh, const Measures& m, double centre_y) {
  const double low = centre_y - m.ramp_half_width;
  const double high = centre_y + m.ramp_half_width;
  // The foot reaches a little below the meadow, so that there is no gap to fall through.
  const Eigen::Vector3d foot_low(kRampStart - 0.5, low, -m.height / 30.0);
  const Eigen::Vector3d foot_high(kRampStart - 0.5, high, -m.height / 30.0);
  const Eigen::Vector3d top_low(m.ramp_end, low, m.height);
  const Eigen::Vector3d top_high(m.ramp_end, high, m.height);
  mesh.add_quad(foot_low, top_low, top_high, foot_high, Material::concrete);
  for (const double side : {low, high}) {
    mesh.add_quad({kRampStart - 0.5, side, -0.2}, {m.ramp_end, side, -0.2},
                  {m.ramp_end, side, m.height}, {kRampStart - 0.5, side, 0.0}, Material::concrete);
    // Railing: posts and a hand rail.
    for (double x = kRampStart; x < m.ramp_end; x += 1.5) {
      const double z = m.height * (x - kRampStart) / (m.ramp_end - kRampStart);
      mesh.add_column({x, side, z}, 0.025, 0.95, Material::painted_metal, 6);
    }
    mesh.add_quad({kRampStart, side, 0.90}, {m.ramp_end, side, m.height + 0.90},
                  {m.ramp_end, side, m.height + 0.96}, {kRampStart, side, 0.96},
                  Material::painted_metal);
  }
}

void add_terrace(TriangleMesh& mesh, const Measures& m) {
  const double south = kSouthRamp - m.ramp_half_width - 2.0;
  const double north = m.north_ramp + m.ramp_half_width + 2.0;
  mesh.add_box({m.ramp_end, south, -0.3}, {m.terrace_far, north, m.height}, Material::concrete);
  const double top = m.height + 0.9;
  const auto parapet = [&](double x0, double y0, double x1, double y1) {
    mesh.add_box({x0, y0, m.height}, {x1, y1, top}, Material::concrete);
  };
  parapet(m.ramp_end, south, m.terrace_far, south + 0.2);
  parapet(m.ramp_end, north - 0.2, m.terrace_far, north);
  parapet(m.terrace_far - 0.2, south, m.terrace_far, north);
  // Towards the ramps the parapet leaves two openings.
  parapet(m.ramp_end, south, m.ramp_end + 0.2, kSouthRamp - m.ramp_half_width);
  parapet(m.ramp_end, kSouthRamp + m.ramp_half_width, m.ramp_end + 0.2,
          m.north_ramp - m.ramp_half_width);
  parapet(m.ramp_end, m.north_ramp + m.ramp_half_width, m.ramp_end + 0.2, north);
  // A pavilion of columns in the middle of the terrace.
  const double west = m.ramp_end + 4.0;
  const double middle = 0.5 * (kSouthRamp + m.north_ramp);
  for (double x = west; x <= west + 10.0; x += 2.5) {
    for (const double y : {middle - 2.0, middle + 2.0}) {
      mesh.add_column({x, y, m.height}, 0.2, 3.0, Material::concrete, 12);
    }
  }
  mesh.add_box({west - 1.0, middle - 3.0, m.height + 3.0},
               {west + 11.0, middle + 3.0, m.height + 3.3}, Material::concrete);
  for (const double y : {south + 0.9, north - 0.9}) {
    for (double x = m.ramp_end + 3.0; x < m.terrace_far - 2.0; x += 4.0) {
      mesh.add_box({x, y - 0.35, m.height}, {x + 1.4, y + 0.35, m.height + 0.55}, Material::brick);
    }
  }
}

/// Houses round the ramps and the terrace; a layout moves and sizes each of them.
void add_houses(TriangleMesh& mesh, const Measures& m, const LayoutDraws& draw) {
  std::uint64_t number = 20;
  // `out` points away from the ramps: a house moves outwards only.
  const auto house = [&](Eigen::Vector2d low, Eigen::Vector2d size, const Eigen::Vector2d& out,
                         int storeys) {
    const double away = draw.between(number, 0.0, 0.0, 8.0);
    const double along = draw.between(number + 1, 0.0, -3.0, 3.0);
    const Eigen::Vector2d drawn(size.x() * draw.between(number + 2, 1.0, 0.7, 1.0),
                                size.y() * draw.between(number + 3, 1.0, 0.7, 1.0));
    low += away * out + along * Eigen::Vector2d(-out.y(), out.x());
    if (out.x() < 0.0) low.x() += size.x() - drawn.x();
    if (out.y() < 0.0) low.y() += size.y() - drawn.y();
    add_building(mesh, low, low + drawn, draw.whole(number + 4, storeys, 1, 6));
    number += 5;
  };
  const double north = m.north_ramp + 10.0;
  const double east = m.terrace_far + 10.0;
  house({-30.0, north}, {36.0, 14.0}, {0.0, 1.0}, 4);
  house({12.0, north + 4.0}, {36.0, 14.0}, {0.0, 1.0}, 3);
  house({east, -10.0}, {16.0, 32.0}, {1.0, 0.0}, 5);
  house({-14.0, -34.0}, {34.0, 16.0}, {0.0, -1.0}, 3);
  house({28.0, -36.0}, {18.0, 16.0}, {0.0, -1.0}, 6);
  house({-52.0, -20.0}, {18.0, 34.0}, {-1.0, 0.0}, 4);
  // A kiosk between the ramps.
  if (draw.first()) {
    add_building(mesh, {7.0, 4.0}, {15.0, 10.0}, 1);
  } else {
    const double gap = m.north_ramp - 2.0 * m.ramp_half_width;
    const double y = 0.5 * m.north_ramp;
    add_building(mesh, {7.0, y - 0.25 * gap}, {m.ramp_end - 3.0, y + 0.25 * gap}, 1);
  }
}

void add_surroundings(TriangleMesh& mesh, const Measures& m, const LayoutDraws& draw,
                      const CounterRandom& random) {
  add_houses(mesh, m, draw);
  std::uint64_t tree = 0;
  const auto plant = [&](double x, double y) {
    const double dx = random.uniform(4 * tree + 1'000'000, -0.8, 0.8);
    const double dy = random.uniform(4 * tree + 1'000'001, -0.8, 0.8);
    const double height = random.uniform(4 * tree + 1'000'002, 4.5, 9.0);
    add_tree(mesh, {x + dx, y + dy, meadow(x + dx, y + dy)}, height, random, tree);
    ++tree;
  };
  for (double x = -26.0; x < 46.0; x += draw.between(60, 9.0, 7.0, 12.0)) plant(x, -11.0);
  for (double x = -26.0; x < 46.0; x += draw.between(61, 10.0, 7.0, 12.0)) {
    plant(x, m.north_ramp + 7.0);
  }
  for (double y = -14.0; y < 20.0; y += draw.between(62, 8.0, 6.0, 11.0)) plant(-18.0, y);
  for (double y = -30.0; y < 40.0; y += 11.0) plant(74.0, y);
  for (double x = -60.0; x < 70.0; x += 12.0) plant(x, 56.0);
  for (double x = -60.0; x < 70.0; x += 12.0) plant(x, -52.0);
  for (double x = -8.0; x < 40.0; x += 12.0) add_lamp(mesh, {x, -5.5, meadow(x, -5.5)});
  for (double y = 2.0; y < 16.0; y += 5.0) {
    add_bench(mesh, {m.start - 5.0, y, meadow(m.start - 5.0, y)}, 1.5708);
  }
  const TriangleMesh car = make_car();
  for (double x = -20.0; x < 40.0; x += 3.1) {
    if (random.uniform(static_cast<std::uint64_t>(x + 100.0) + 2'000'000) < 0.35) continue;
    mesh.add_mesh(placed(car, {x, -15.0, 0.0}, 1.5708));
  }
}

}  // namespace

Scene campus(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeCampus);
  const Measures m = measures(draw);
  const CounterRandom random(seeds.things, kPurposeCampus);
  Scene scene;
  scene.mesh.add_heightfield({-kCampusHalf, -kCampusHalf}, {kCampusHalf, kCampusHalf}, 0.75, meadow,
                             Material::grass);
  add_ramp(scene.mesh, m, kSouthRamp);
  add_ramp(scene.mesh, m, m.north_ramp);
  add_terrace(scene.mesh, m);
  add_surroundings(scene.mesh, m, draw, random);
  const double t = m.height;
  const double far = m.terrace_far - 3.5;
  scene.route = {{m.start, 0.5 * m.north_ramp, 0.0},
                 {m.start, kSouthRamp, 0.0},
                 {kRampStart, kSouthRamp, 0.0},
                 {m.ramp_end, kSouthRamp, t},
                 {far, kSouthRamp, t},
                 {far, m.north_ramp, t},
                 {m.ramp_end, m.north_ramp, t},
                 {kRampStart, m.north_ramp, 0.0},
                 {m.start, m.north_ramp, 0.0}};
  scene.corner_rounding = 0.7;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
