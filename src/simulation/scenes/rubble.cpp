// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeRubble = 207;
constexpr double kHalf = 40.0;  // [m]

/// The way round, by direction from the middle.
struct Way {
  double mean;
  double dent;
  double turned;
  [[nodiscard]] double radius(double angle) const {
    return mean * (1.0 + dent * std::sin(2.0 * angle + turned));
  }
};

/// Heaps and hollows.
double debris(double x, double y) {
  return 0.10 * std::sin(0.7 * x) * std::cos(0.9 * y) + 0.04 * std::sin(2.1 * x + 1.3 * y) +
         0.02 * std::sin(5.3 * x) * std::sin(4.9 * y);
}

/// A broken slab: a thin box that lies tilted.
void add_slab(TriangleMesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
              const Eigen::Vector3d& angles) {
  TriangleMesh slab;
  slab.add_box(-0.5 * size, 0.5 * size, Material::concrete);
  const Eigen::Quaterniond turn = from_roll_pitch_yaw(angles);
  for (Eigen::Vector3f& vertex : slab.vertices) {
    vertex = (turn * vertex.cast<double>() + centre).cast<float>();
  }
  mesh.add_mesh(slab);
}

void add_slabs(TriangleMesh& mesh, const Way& way, const CounterRandom& random) {
  constexpr std::uint64_t kSlabs = 1500;
  for (std::uint64_t i = 0; i < kSlabs; ++i) {
    const std::uint64_t draw = 16 * i;
    const double x = random.uniform(draw, -24.0, 24.0);
    const double y = random.uniform(draw + 1, -24.0, 24.0);
    const double off_route = std::abs(std::hypot(x, y) - way.radius(std::atan2(y, x)));
    // Slabs on the way are what a Go2 steps over; beside it they pile up.
    const bool on_way = off_route < 1.6;
    const double extent =
        on_way ? random.uniform(draw + 2, 0.2, 0.6) : random.uniform(draw + 2, 0.4, 1.8);
    const double thickness =
        on_way ? random.uniform(draw + 3, 0.03, 0.09) : random.uniform(draw + 3, 0.1, 0.35);
    const double tilt = on_way ? 0.08 : 0.6;
    const double lift = off_route > 3.0 ? random.uniform(draw + 4, 0.0, 0.7) : 0.0;
    add_slab(mesh, {x, y, debris(x, y) + lift}, {extent, 0.7 * extent, thickness},
             {random.uniform(draw + 5, -tilt, tilt), random.uniform(draw + 6, -tilt, tilt),
              random.uniform(draw + 7, 0.0, 3.1416)});
  }
}

void add_ruin(TriangleMesh& mesh, double x, double y, const CounterRandom& random,
              std::uint64_t counter) {
  for (std::uint64_t i = 0; i < 5; ++i) {
    const double along = static_cast<double>(i) * 1.6;
    const double height = random.uniform(counter + i, 1.0, 5.5);
    mesh.add_box({x + along, y, -0.3}, {x + along + 1.6, y + 0.3, height}, Material::brick);
    mesh.add_box({x, y + along, -0.3}, {x + 0.3, y + along + 1.6, 0.7 * height}, Material::brick);
  }
}

}  // namespace

Scene rubble(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeRubble);
  const Way way{draw.between(1, 9.0, 7.5, 12.0), draw.between(2, 0.0, 0.05, 0.25),
                draw.between(3, 0.0, 0.0, 6.28)};
  const CounterRandom random(seeds.things, kPurposeRubble);
  Scene scene;
  scene.mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.25, debris, Material::rock);
  add_slabs(scene.mesh, way, random);
  add_ruin(scene.mesh, 16.0 + draw.between(10, 0.0, 0.0, 6.0),
           8.0 + draw.between(11, 0.0, -1.0, 6.0), random, 900'000);
  add_ruin(scene.mesh, -22.0 + draw.between(12, 0.0, -6.0, 0.0),
           12.0 + draw.between(13, 0.0, -1.0, 6.0), random, 900'100);
  add_ruin(scene.mesh, -18.0 + draw.between(14, 0.0, -6.0, 0.0),
           -20.0 + draw.between(15, 0.0, -6.0, 0.0), random, 900'200);
  add_ruin(scene.mesh, 12.0 + draw.between(16, 0.0, 0.0, 6.0),
           -22.0 + draw.between(17, 0.0, -6.0, 0.0), random, 900'300);
  add_building(scene.mesh, {draw.between(4, 26.0, 25.0, 33.0), -18.0},
               {38.0, draw.between(5, 6.0, -6.0, 10.0)}, draw.whole(6, 3, 1, 5));
  add_building(scene.mesh, {-38.0, -8.0}, {draw.between(7, -28.0, -34.0, -27.0), 8.0},
               draw.whole(8, 2, 1, 5));
  constexpr int kCorners = 28;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCorners;
    const double x = way.radius(angle) * std::cos(angle);
    const double y = way.radius(angle) * std::sin(angle);
    scene.route.emplace_back(x, y, debris(x, y));
  }
  scene.robot = "walk";
  return scene;
}

}  // namespace surefoot::simulation
