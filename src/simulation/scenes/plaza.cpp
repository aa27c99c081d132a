// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposePlaza = 208;
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kRoadY = -20.0;   // middle of the road [m]
constexpr double kRoadEnd = 70.0;  // cars drive from -kRoadEnd to kRoadEnd and start again

/// A person on a circle, clear of the robot's way.
MovingObject walker(const Eigen::Vector2d& centre, double radius, double speed, double start) {
  MovingObject object;
  object.mesh = make_person();
  object.T_map_object = [=](double time) {
    const double angle = start + speed * time / radius;
    const Eigen::Vector3d at(centre.x() + radius * std::cos(angle),
                             centre.y() + radius * std::sin(angle), 0.0);
    const double heading = angle + (speed > 0.0 ? 0.25 : -0.25) * kTwoPi;
    return Pose{from_roll_pitch_yaw({0.0, 0.0, heading}), at};
  };
  return object;
}

/// A car on the road. Where it would start anew it is out of sight behind the houses.
MovingObject driver(double lane, double speed, double start) {
  MovingObject object;
  object.mesh = make_car();
  object.T_map_object = [=](double time) {
    const double way = start + std::abs(speed) * time;
    const double span = 2.0 * kRoadEnd;
    const double along = way - span * std::floor(way / span) - kRoadEnd;
    const double x = speed > 0.0 ? along : -along;
    return Pose{from_roll_pitch_yaw({0.0, 0.0, speed > 0.0 ? 0.0 : std::numbers::pi}),
                {x, kRoadY + lane, 0.0}};
  };
  return object;
}

void add_square(TriangleMesh& mesh, const LayoutDraws& draw) {
  mesh.add_quad({-90, -60, 0}, {90, -60, 0}, {90, 60, 0}, {-90, 60, 0}, Material::concrete);
  add_building(mesh, {-34.0, draw.between(1, 22.0, 21.0, 30.0)}, {34.0, 34.0},
               draw.whole(2, 4, 2, 6));
  add_building(mesh, {-48.0, -14.0}, {draw.between(3, -36.0, -42.0, -34.0), 34.0},
               draw.whole(4, 3, 2, 6));
  add_building(mesh, {draw.between(5, 36.0, 34.0, 42.0), -14.0}, {50.0, 34.0},
               draw.whole(6, 4, 2, 6));
  add_building(mesh, {-90.0, -42.0}, {draw.between(7, -16.0, -24.0, -13.0), -27.0},
               draw.whole(8, 5, 2, 6));
  add_building(mesh, {draw.between(9, -10.0, -12.0, 8.0), -42.0}, {90.0, -27.0},
               draw.whole(10, 3, 2, 6));
  mesh.add_column({0.0, 2.0, 0.0}, draw.between(11, 3.0, 1.8, 3.1), 0.55, Material::rock,
                  24);  // fountain
  mesh.add_column({0.0, 2.0, 0.55}, 0.5, 2.2, Material::rock, 12, 0.25);
  const double kiosk = draw.between(12, 4.0, -8.0, 10.0);
  mesh.add_box({-33.0, kiosk, 0.0}, {-30.0, kiosk + 3.0, 2.6}, Material::painted_metal);
  mesh.add_box({22.0, -9.0, 0.0}, {25.0, -6.0, 2.6}, Material::painted_metal);
  for (double x = -30.0; x <= 30.0; x += draw.between(13, 10.0, 8.0, 14.0)) {
    add_lamp(mesh, {x, -15.5, 0.0});
  }
  for (double x = -24.0; x <= 24.0; x += draw.between(14, 12.0, 8.0, 16.0)) {
    add_bench(mesh, {x, 18.5, 0.0}, 3.1416);
  }
}

}  // namespace

Scene plaza(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposePlaza);
  const CounterRandom random(seeds.things, kPurposePlaza);
  Scene scene;
  add_square(scene.mesh, draw);
  for (std::uint64_t i = 0; i < 8; ++i) {
    add_tree(scene.mesh, {-28.0 + 8.0 * static_cast<double>(i), 15.5, 0.0},
             random.uniform(9'000'000 + i, 4.5, 7.0), random, i);
  }
  // Ten walk round the fountain inside the robot's loop, the others outside of it.
  for (std::uint64_t i = 0; i < 22; ++i) {
    const std::uint64_t counter = 8'000'000 + 8 * i;
    const double speed = random.uniform(counter, 0.8, 1.6) * (i % 2 == 0 ? 1.0 : -1.0);
    const double start = kTwoPi * random.uniform(counter + 1);
    if (i < 10) {
      scene.moving.push_back(walker({0.0, 2.0}, 3.8 + 0.22 * static_cast<double>(i), speed, start));
    } else {
      const double x = -24.0 + 8.0 * static_cast<double>((i - 10) % 7);
      scene.moving.push_back(walker({x, i % 3 == 0 ? -12.5 : 13.0},
                                    random.uniform(counter + 2, 0.8, 1.8), speed, start));
    }
  }
  for (std::uint64_t i = 0; i < 6; ++i) {
    const std::uint64_t counter = 8'500'000 + 8 * i;
    const bool east = i % 2 == 0;
    scene.moving.push_back(
        driver(east ? -1.7 : 1.7, (east ? 1.0 : -1.0) * 8.0,
               47.0 * static_cast<double>(i / 2) + random.uniform(counter, 0, 12)));
  }
  // Round those who walk about the fountain, inside of those who walk along the sides.
  const double south = draw.between(20, -7.0, -8.5, -6.0);
  const double north = draw.between(21, 9.5, 9.0, 9.8);
  scene.route = {{draw.between(22, -14.0, -20.0, -9.0), south, 0},
                 {draw.between(23, 14.0, 9.0, 20.0), south, 0},
                 {draw.between(24, 14.0, 9.0, 20.0), north, 0},
                 {draw.between(25, -14.0, -20.0, -9.0), north, 0}};
  scene.corner_rounding = 0.8;
  scene.robot = "trot";
  return scene;
}

}  // namespace surefoot::simulation
