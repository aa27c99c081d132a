// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeFoyer = 212;
constexpr double kHeight = 4.2;  // [m]
constexpr double kMullionEvery = 2.4;

/// A glass wall with mullions, a sill and a lintel of metal.
void add_front(TriangleMesh& mesh, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const auto at = [](const Eigen::Vector2d& place, double z) {
    return Eigen::Vector3d(place.x(), place.y(), z);
  };
  mesh.add_quad(at(from, 0.0), at(to, 0.0), at(to, kHeight), at(from, kHeight), Material::pane);
  const int bays = std::max(1, static_cast<int>((to - from).norm() / kMullionEvery));
  for (int i = 0; i <= bays; ++i) {
    const Eigen::Vector2d place = from + (to - from) * (static_cast<double>(i) / bays);
    mesh.add_box(at(place, 0.0) - Eigen::Vector3d(0.03, 0.03, 0.0),
                 at(place, kHeight) + Eigen::Vector3d(0.03, 0.03, 0.0), Material::painted_metal);
  }
  const Eigen::Vector3d thick(0.03, 0.03, 0.0);
  for (const double z : {0.0, kHeight - 0.15}) {
    const Eigen::Vector3d a = at(from.cwiseMin(to), z);
    const Eigen::Vector3d b = at(from.cwiseMax(to), z + 0.12);
    mesh.add_box(a - thick, b + thick, Material::painted_metal);
  }
}

void add_outside(TriangleMesh& mesh, const Eigen::Vector2d& half, const CounterRandom& random) {
  for (std::uint64_t i = 0; i < 26; ++i) {
    const std::uint64_t draw = 100 + 4 * i;
    const double angle = 0.2417 * static_cast<double>(i);
    const double away = half.norm() + random.uniform(draw, 3.0, 16.0);
    const Eigen::Vector3d foot(away * std::cos(angle), away * std::sin(angle), 0.0);
    add_tree(mesh, foot, random.uniform(draw + 1, 4.0, 8.0), random, i);
  }
  add_building(mesh, {-half.x() - 10.0, half.y() + 22.0}, {half.x(), half.y() + 34.0}, 3);
  add_building(mesh, {half.x() + 24.0, -20.0}, {half.x() + 36.0, 14.0}, 4);
  for (double x = -half.x(); x < half.x(); x += 7.0) add_lamp(mesh, {x, -half.y() - 5.0, 0.0});
  const TriangleMesh car = make_car();
  for (double x = -half.x(); x < half.x(); x += 5.5) {
    mesh.add_mesh(placed(car, {x, -half.y() - 9.0, 0.0}, random.uniform(500, -0.1, 0.1)));
  }
}

}  // namespace

Scene foyer(const SceneSeeds& seeds) {
  const CounterRandom random(seeds.layout, kPurposeFoyer);
  const Eigen::Vector2d half(random.uniform(1, 13.0, 19.0), random.uniform(2, 8.0, 11.0));
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_quad({-90, -90, 0}, {90, -90, 0}, {90, 90, 0}, {-90, 90, 0}, Material::concrete);
  mesh.add_box({-half.x() - 1.0, -half.y() - 1.0, kHeight},
               {half.x() + 1.0, half.y() + 1.0, kHeight + 0.4}, Material::concrete);
  // Three sides are of glass, the fourth is the building that the foyer belongs to.
  const Eigen::Vector2d b(half.x(), -half.y());
  add_front(mesh, -half, b);
  add_front(mesh, b, half);
  add_front(mesh, -half, {-half.x(), half.y()});
  mesh.add_box({-half.x(), half.y(), 0.0}, {half.x(), half.y() + 0.3, kHeight}, Material::brick);
  // A meeting room of glass in the middle: the way goes round it.
  const Eigen::Vector2d room(random.uniform(3, 2.5, 4.5), random.uniform(4, 1.6, 2.6));
  const Eigen::Vector2d c(room.x(), -room.y());
  add_front(mesh, -room, c);
  add_front(mesh, c, room);
  add_front(mesh, {-room.x(), room.y()}, room);
  add_front(mesh, -room, {-room.x(), room.y()});
  mesh.add_box({-1.2, -0.5, 0.70}, {1.2, 0.5, 0.75}, Material::bark);  // its table
  // Columns in the corners between room and fronts, furniture along the fronts.
  const Eigen::Vector2d way = 0.5 * (half + room);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      mesh.add_column({x * (way.x() + 1.7), y * (way.y() + 1.4), 0.0}, 0.25, kHeight,
                      Material::concrete, 14);
    }
  }
  const double counter = random.uniform(5, -0.5, 0.1) * half.x();
  mesh.add_box({counter, half.y() - 1.1, 0.0}, {counter + 4.0, half.y() - 0.4, 1.1},
               Material::bark);
  for (std::uint64_t i = 0; i < 4; ++i) {
    const double x = (-0.7 + 0.4 * static_cast<double>(i)) * half.x();
    add_bench(mesh, {x + random.uniform(10 + i, -0.6, 0.6), -half.y() + 0.6, 0.0}, 3.1416);
  }
  add_outside(mesh, half, CounterRandom(seeds.things, kPurposeFoyer));
  scene.route = {{-way.x(), -way.y(), 0.0},
                 {way.x(), -way.y(), 0.0},
                 {way.x(), way.y(), 0.0},
                 {-way.x(), way.y(), 0.0}};
  scene.corner_rounding = 0.8;
  scene.robot = "trot";
  scene.view_ceiling = kHeight - 0.1;
  scene.view_margin = 6.0;
  return scene;
}

}  // namespace surefoot::simulation
