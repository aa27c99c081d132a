// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scenes/furniture.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace surefoot::simulation {

namespace {
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kStorey = 3.2;  // [m]

/// One wall with a row of windows, each a pane set back by 15 cm. The wall runs from `a` to `b`;
/// inward is to its left.
void add_wall(TriangleMesh& mesh, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bottom,
              double top) {
  constexpr double kBay = 3.0;
  constexpr double kRecess = 0.15;
  const double length = (b - a).norm();
  const Eigen::Vector2d along = (b - a) / length;
  const Eigen::Vector2d inward(-along.y(), along.x());
  const int bays = std::max(1, static_cast<int>(length / kBay));
  const double bay = length / bays;
  const double sill = bottom + 0.9;
  const double lintel = top - 0.7;
  const auto at = [&](double distance, double depth, double z) {
    const Eigen::Vector2d p = a + distance * along + depth * inward;
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  const auto panel = [&](double from, double to, double depth, double low, double high,
                         Material material) {
    mesh.add_quad(at(from, depth, low), at(to, depth, low), at(to, depth, high),
                  at(from, depth, high), material);
  };
  panel(0.0, length, 0.0, bottom, sill, Material::brick);
  panel(0.0, length, 0.0, lintel, top, Material::brick);
  for (int i = 0; i < bays; ++i) {
    const double left = bay * i;
    const double opening = left + 0.25 * bay;
    const double closing = left + 0.75 * bay;
    panel(left, opening, 0.0, sill, lintel, Material::brick);
    panel(closing, left + bay, 0.0, sill, lintel, Material::brick);
    panel(opening, closing, kRecess, sill, lintel, Material::glass);
    for (const double edge : {opening, closing}) {
      mesh.add_quad(at(edge, 0.0, sill), at(edge, kRecess, sill), at(edge, kRecess, lintel),
                    at(edge, 0.0, lintel), Material::brick);
    }
    for (const double level : {sill, lintel}) {
      mesh.add_quad(at(opening, 0.0, level), at(closing, 0.0, level), at(closing, kRecess, level),
                    at(opening, kRecess, level), Material::concrete);
    }
  }
}
}  // namespace

void add_tree(TriangleMesh& mesh, const Eigen::Vector3d& foot, double height,
              const CounterRandom& random, std::uint64_t counter) {
  constexpr int kLeaves = 260;
  const std::uint64_t first = counter * 2048;
  const double trunk = 0.35 * height;
  mesh.add_column(foot - Eigen::Vector3d(0, 0, 0.3), 0.03 * height, trunk + 0.8, Material::bark, 8,
                  0.02 * height);
  const Eigen::Vector3d crown = foot + Eigen::Vector3d(0.0, 0.0, trunk + 0.33 * height);
  const double radius = 0.27 * height;
  for (std::uint64_t leaf = 0; leaf < kLeaves; ++leaf) {
    const std::uint64_t draw = first + 7 * leaf;
    const double around = kTwoPi * random.uniform(draw);
    const double up = random.uniform(draw + 1, -1.0, 1.0);
    const double out = std::cbrt(random.uniform(draw + 2, 0.15, 1.0));
    const double flat = std::sqrt(1.0 - up * up);
    const Eigen::Vector3d centre =
        crown +
        radius * out * Eigen::Vector3d(flat * std::cos(around), flat * std::sin(around), 1.25 * up);
    const double size = random.uniform(draw + 3, 0.12, 0.3);
    const Eigen::Vector3d a(random.uniform(draw + 4, -1, 1), random.uniform(draw + 5, -1, 1),
                            random.uniform(draw + 6, -1, 1));
    const Eigen::Vector3d side = size * a.normalized();
    const Eigen::Vector3d other = size * a.cross(Eigen::Vector3d(0.3, 0.5, 0.8)).normalized();
    mesh.add_quad(centre - side, centre - other, centre + side, centre + other, Material::foliage);
  }
}

void add_building(TriangleMesh& mesh, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                  int storeys, double ground) {
  const Eigen::Vector2d b(high.x(), low.y());
  const Eigen::Vector2d d(low.x(), high.y());
  for (int storey = 0; storey < storeys; ++storey) {
    const double bottom = ground + kStorey * storey - (storey == 0 ? 0.3 : 0.0);
    const double top = ground + kStorey * (storey + 1);
    add_wall(mesh, low, b, bottom, top);
    add_wall(mesh, b, high, bottom, top);
    add_wall(mesh, high, d, bottom, top);
    add_wall(mesh, d, low, bottom, top);
  }
  const double roof = ground + kStorey * storeys;
  mesh.add_box({low.x() - 0.4, low.y() - 0.4, roof}, {high.x() + 0.4, high.y() + 0.4, roof + 0.3},
               Material::concrete);
}

void add_lamp(TriangleMesh& mesh, const Eigen::Vector3d& foot) {
  mesh.add_column(foot - Eigen::Vector3d(0, 0, 0.1), 0.09, 5.1, Material::painted_metal, 10, 0.06);
  mesh.add_box(foot + Eigen::Vector3d(-0.15, -0.15, 4.9), foot + Eigen::Vector3d(1.0, 0.15, 5.05),
               Material::painted_metal);
}

void add_bench(TriangleMesh& mesh, const Eigen::Vector3d& foot, double yaw) {
  TriangleMesh bench;
  bench.add_box({-0.8, -0.22, 0.40}, {0.8, 0.22, 0.46}, Material::bark);
  bench.add_box({-0.8, 0.20, 0.46}, {0.8, 0.25, 0.85}, Material::bark);
  for (const double x : {-0.65, 0.6}) {
    bench.add_box({x, -0.2, -0.05}, {x + 0.06, 0.2, 0.40}, Material::painted_metal);
  }
  mesh.add_mesh(placed(bench, foot, yaw));
}

TriangleMesh make_car() {
  TriangleMesh car;
  car.add_box({-2.15, -0.88, 0.28}, {2.15, 0.88, 0.85}, Material::painted_metal);
  car.add_quad({-1.7, -0.8, 0.85}, {-1.2, -0.68, 1.45}, {-1.2, 0.68, 1.45}, {-1.7, 0.8, 0.85},
               Material::glass);
  car.add_quad({1.2, -0.8, 0.85}, {0.4, -0.68, 1.45}, {0.4, 0.68, 1.45}, {1.2, 0.8, 0.85},
               Material::glass);
  car.add_quad({-1.2, -0.68, 1.45}, {0.4, -0.68, 1.45}, {0.4, 0.68, 1.45}, {-1.2, 0.68, 1.45},
               Material::painted_metal);
  for (const double side : {-1.0, 1.0}) {
    car.add_quad({-1.7, side * 0.8, 0.85}, {1.2, side * 0.8, 0.85}, {0.4, side * 0.68, 1.45},
                 {-1.2, side * 0.68, 1.45}, Material::glass);
    for (const double x : {-1.35, 1.35}) {
      car.add_box({x - 0.3, side * 0.8 - 0.1, 0.0}, {x + 0.3, side * 0.8 + 0.1, 0.6},
                  Material::rubber);
    }
  }
  return car;
}

TriangleMesh make_person() {
  TriangleMesh person;
  for (const double side : {-0.1, 0.1}) {
    person.add_column({0.0, side, 0.0}, 0.07, 0.85, Material::cloth, 8, 0.09);
  }
  person.add_column({0.0, 0.0, 0.85}, 0.17, 0.6, Material::cloth, 10, 0.2);
  for (const double side : {-0.25, 0.25}) {
    person.add_column({0.0, side, 0.8}, 0.05, 0.6, Material::cloth, 6);
  }
  person.add_ball({0.0, 0.0, 1.62}, 0.12, Material::cloth);
  return person;
}

TriangleMesh placed(TriangleMesh mesh, const Eigen::Vector3d& at, double yaw) {
  const auto c = static_cast<float>(std::cos(yaw));
  const auto s = static_cast<float>(std::sin(yaw));
  const Eigen::Vector3f shift = at.cast<float>();
  for (Eigen::Vector3f& vertex : mesh.vertices) {
    vertex = Eigen::Vector3f(c * vertex.x() - s * vertex.y(), s * vertex.x() + c * vertex.y(),
                             vertex.z()) +
             shift;
  }
  return mesh;
}

}  // namespace surefoot::simulation
