// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"
#include "simulation/scenes/terrain.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeForest = 205;
constexpr double kHalf = 55.0;  // [m]
constexpr int kStones = 160;

/// A hill with hollows, humps and roots.
class Hill {
 public:
  explicit Hill(const LayoutDraws& draw)
      : height_(draw.between(1, 6.0, 3.5, 8.5)),
        width_(draw.between(2, 18.0, 15.0, 24.0)),
        flattened_(draw.between(3, 1.4, 0.7, 1.6)),
        shift_(draw.between(4, 0.0, -40.0, 40.0), draw.between(5, 0.0, -40.0, 40.0)) {}

  [[nodiscard]] double operator()(double x, double y) const {
    const double broad =
        height_ * std::exp(-(x * x + flattened_ * y * y) / (2.0 * width_ * width_));
    // Humps of another layout are those of another place.
    const double u = x + shift_.x();
    const double v = y + shift_.y();
    return broad + 0.6 * std::sin(0.21 * u + 1.0) * std::sin(0.17 * v + 0.4) +
           0.18 * std::sin(0.83 * u + 0.5 * v) +
           0.07 * std::sin(1.9 * u - 0.3) * std::cos(2.3 * v) +
           0.025 * std::sin(5.1 * u + 1.0) * std::sin(4.7 * v);
  }

 private:
  double height_;
  double width_;
  double flattened_;
  Eigen::Vector2d shift_;
};

void add_conifer(TriangleMesh& mesh, const Eigen::Vector3d& foot, double height) {
  mesh.add_column(foot - Eigen::Vector3d(0, 0, 0.4), 0.02 * height, 0.9 * height, Material::bark, 8,
                  0.006 * height);
  for (int whorl = 0; whorl < 4; ++whorl) {
    const double z = height * (0.32 + 0.15 * whorl);
    mesh.add_column(foot + Eigen::Vector3d(0.0, 0.0, z), height * (0.17 - 0.03 * whorl),
                    0.2 * height, Material::foliage, 9, 0.02 * height);
  }
}

}  // namespace

Scene forest(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeForest);
  const Hill hill(draw);
  const CounterRandom random(seeds.things, kPurposeForest);
  const int trees = draw.whole(6, 420, 250, 650);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  mesh.add_heightfield({-kHalf, -kHalf}, {kHalf, kHalf}, 0.3, hill, Material::grass);
  const double mean = draw.between(7, 13.0, 11.5, 17.0);
  const double lobe = draw.between(8, 4.5, 2.0, 4.5);
  const double turned = draw.between(9, 0.7, 0.0, 6.28);
  constexpr int kCorners = 40;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCorners;
    const double radius =
        mean + lobe * std::sin(3.0 * angle + turned) + 1.2 * std::sin(7.0 * angle);
    const double x = radius * std::cos(angle) + 4.0;
    const double y = radius * std::sin(angle);
    scene.route.emplace_back(x, y, hill(x, y));
  }
  const RouteSegments way(scene.route);
  const auto place = [&](std::uint64_t counter) {
    return Eigen::Vector2d(random.uniform(counter, -kHalf + 2, kHalf - 2),
                           random.uniform(counter + 1, -kHalf + 2, kHalf - 2));
  };
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(trees); ++i) {
    const Eigen::Vector2d at = place(10'000'000 + 8 * i);
    if (way.distance(at) < 1.3) continue;
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
    if (way.distance(at) < radius + 0.6) continue;
    mesh.add_ball({at.x(), at.y(), hill(at.x(), at.y())}, radius, Material::rock, 9);
  }
  scene.corner_rounding = 0.6;
  scene.robot = "trot";
  scene.view_ceiling = 9.0;
  return scene;
}

}  // namespace surefoot::simulation
