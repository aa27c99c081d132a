// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeForest = 205;
constexpr double kHalf = 55.0;  // [m]
constexpr int kTrees = 420;
constexpr int kStones = 160;

/// A hill of 6 m with hollows, humps and roots.
double hill(double x, double y) {
  const double broad = 6.0 * std::exp(-(x * x + 1.4 * y * y) / (2.0 * 18.0 * 18.0));
  return broad + 0.6 * std::sin(0.21 * x + 1.0) * std::sin(0.17 * y + 0.4) +
         0.18 * std::sin(0.83 * x + 0.5 * y) + 0.07 * std::sin(1.9 * x - 0.3) * std::cos(2.3 * y) +
         0.025 * std::sin(5.1 * x + 1.0) * std::sin(4.7 * y);
}

double distance_to_route(const std::vector<Eigen::Vector3d>& route, const Eigen::Vector2d& point) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d a = route[i].head<2>();
    const Eigen::Vector2d edge = route[(i + 1) % route.size()].head<2>() - a;
    const double part = std::clamp(edge.dot(point - a) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - a - part * edge).norm());
  }
  return nearest;
}

void add_conifer(TriangleMesh& mesh, const Eigen::Vector3d& foot, double height) {
  mesh.add_column(foot - Eigen::Vector3d(0, 0, 0.4), 0.02 * height, 0.9 * height, Material::kBark,
                  8, 0.006 * height);
  for (int whorl = 0; whorl < 4; ++whorl) {
    const double z = height * (0.32 + 0.15 * whorl);
    mesh.add_column(foot + Eigen::Vector3d(0.0, 0.0, z), height * (0.17 - 0.03 * whorl),
                    0.2 * height, Material::kFoliage, 9, 0.02 * height);
  }
}

}  // namespace

Scene forest(std::uint64_t seed) {
  const CounterRandom random(seed, kPurposeForest);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.3, hill, Material::kGrass);
  constexpr int kCorners = 40;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCorners;
    const double radius = 13.0 + 4.5 * std::sin(3.0 * angle + 0.7) + 1.2 * std::sin(7.0 * angle);
    const double x = radius * std::cos(angle) + 4.0;
    const double y = radius * std::sin(angle);
    scene.route.emplace_back(x, y, hill(x, y));
  }
  const auto place = [&](std::uint64_t counter) {
    return Eigen::Vector2d(random.uniform(counter, -kHalf + 2, kHalf - 2),
                           random.uniform(counter + 1, -kHalf + 2, kHalf - 2));
  };
  for (std::uint64_t i = 0; i < kTrees; ++i) {
    const Eigen::Vector2d at = place(10'000'000 + 8 * i);
    if (distance_to_route(scene.route, at) < 1.3) continue;
    const Eigen::Vector3d foot(at.x(), at.y(), hill(at.x(), at.y()));
    const double height = random.uniform(10'000'002 + 8 * i, 6.0, 14.0);
    if (i % 4 == 0) {
      add_tree(mesh, foot, 0.7 * height, random, i);
    } else {
      add_conifer(mesh, foot, height);
    }
  }
  for (std::uint64_t i = 0; i < kStones; ++i) {
    const Eigen::Vector2d at = place(20'000'000 + 8 * i);
    const double radius = random.uniform(20'000'002 + 8 * i, 0.1, 0.6);
    if (distance_to_route(scene.route, at) < radius + 0.6) continue;
    mesh.add_ball({at.x(), at.y(), hill(at.x(), at.y())}, radius, Material::kRock, 9);
  }
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  scene.view_ceiling = 9.0;
  return scene;
}

}  // namespace surefoot::simulation
