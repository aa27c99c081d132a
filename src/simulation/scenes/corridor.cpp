// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>

#include "simulation/scenes/furniture.hpp"
#include "simulation/scenes/scenes.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeCorridor = 206;
constexpr double kDoorHeight = 2.05;  // [m]
constexpr double kDoorDepth = 0.08;   // doors hardly stand back: along the corridor all looks alike
constexpr double kLane = 0.55;        // there on one side of the middle, back on the other

struct Measures {
  double length;  ///< of the whole way [m]
  double half_width;
  double height;
  double door_every;
  double door_width;
  int turns;
};

Measures measures(const LayoutDraws& draw) {
  return {draw.between(1, 60.0, 50.0, 80.0), draw.between(2, 1.2, 1.05, 1.5),
          draw.between(3, 2.7, 2.45, 3.0),   draw.between(4, 5.0, 3.6, 6.5),
          draw.between(5, 0.95, 0.85, 1.05), draw.whole(6, 0, 0, 3)};
}

/// A straight piece of the corridor, its own x along it; turns are to the left (1) or right (-1).
struct Piece {
  Eigen::Vector2d from;
  Eigen::Vector2d along;
  double length = 0.0;
  double turn_before = 0.0;  ///< 0: none, here the corridor begins
  double turn_after = 0.0;

  [[nodiscard]] Eigen::Vector3d at(double x, double y, double z) const {
    const Eigen::Vector2d place = from + x * along + y * Eigen::Vector2d(-along.y(), along.x());
    return {place.x(), place.y(), z};
  }
};

std::vector<Piece> pieces(const Measures& m, const LayoutDraws& draw) {
  std::vector<Piece> result;
  const double length = m.length / (m.turns + 1);
  // Left and right take turns, so that it never comes back to where it was.
  double side = draw.between(7, 1.0, -1.0, 1.0) > 0.0 ? 1.0 : -1.0;
  Piece piece{Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX(), length, 0.0, 0.0};
  for (int i = 0; i <= m.turns; ++i) {
    piece.turn_after = i < m.turns ? side : 0.0;
    result.push_back(piece);
    piece.from += length * piece.along;
    piece.along = side * Eigen::Vector2d(-piece.along.y(), piece.along.x());
    piece.turn_before = side;
    side = -side;
  }
  return result;
}

/// The wall at y = side * half width with shallow doors.
void add_wall(TriangleMesh& mesh, const Piece& piece, const Measures& m, double side) {
  const double y = side * m.half_width;
  const double back = y + side * kDoorDepth;
  // At a bend the inner wall ends before the corner, the outer one behind it.
  const double begin = side * piece.turn_before * m.half_width;
  const double end = piece.length - side * piece.turn_after * m.half_width;
  const auto panel = [&](double x0, double x1, double at, double z0, double z1) {
    mesh.add_quad(piece.at(x0, at, z0), piece.at(x1, at, z0), piece.at(x1, at, z1),
                  piece.at(x0, at, z1), Material::concrete);
  };
  double x = begin;
  for (double door = 0.5 * m.door_every; door < end; door += m.door_every) {
    const double shut = door + m.door_width;
    if (door < begin + 0.1 || shut > end - 0.1) continue;  // no door in a corner
    panel(x, door, y, 0.0, m.height);
    panel(door, shut, y, kDoorHeight, m.height);
    panel(door, shut, back, 0.0, kDoorHeight);
    for (const double edge : {door, shut}) {
      mesh.add_quad(piece.at(edge, y, 0.0), piece.at(edge, back, 0.0),
                    piece.at(edge, back, kDoorHeight), piece.at(edge, y, kDoorHeight),
                    Material::concrete);
    }
    mesh.add_quad(piece.at(door, y, kDoorHeight), piece.at(shut, y, kDoorHeight),
                  piece.at(shut, back, kDoorHeight), piece.at(door, back, kDoorHeight),
                  Material::concrete);
    x = shut;
  }
  panel(x, end, y, 0.0, m.height);
}

void add_floor_and_ceiling(TriangleMesh& mesh, const Piece& piece, const Measures& m) {
  const double w = m.half_width + kDoorDepth;
  const double begin = piece.turn_before == 0.0 ? 0.0 : -w;
  const double end = piece.turn_after == 0.0 ? piece.length : piece.length + w;
  for (const double z : {0.0, m.height}) {
    mesh.add_quad(piece.at(begin, -w, z), piece.at(end, -w, z), piece.at(end, w, z),
                  piece.at(begin, w, z), Material::concrete);
  }
  const auto close = [&](double x) {
    mesh.add_quad(piece.at(x, -w, 0), piece.at(x, w, 0), piece.at(x, w, m.height),
                  piece.at(x, -w, m.height), Material::brick);
  };
  if (piece.turn_before == 0.0) close(0.0);
  if (piece.turn_after == 0.0) close(piece.length);
}

/// The only things that tell one place from another: a few radiators.
void add_radiators(TriangleMesh& mesh, const std::vector<Piece>& pieces, const Measures& m,
                   const CounterRandom& random) {
  for (std::uint64_t i = 0; i < 4; ++i) {
    const double way = 15.0 * static_cast<double>(i) + random.uniform(2 * i, 4.0, 6.0);
    const double side = random.uniform(2 * i + 1) < 0.5 ? -1.0 : 1.0;
    const auto which = static_cast<std::size_t>(way / pieces.front().length);
    if (which >= pieces.size()) break;
    const Piece& piece = pieces[which];
    const double x = way - static_cast<double>(which) * piece.length;
    // Bends stay clear.
    const bool beside_bend =
        pieces.size() > 1 && (x < m.half_width || x + 0.9 > piece.length - m.half_width);
    if (beside_bend) continue;
    const Eigen::Vector3d inner = piece.at(x, side * (m.half_width - 0.1), 0.15);
    const Eigen::Vector3d outer = piece.at(x + 0.9, side * m.half_width, 0.75);
    mesh.add_box(inner.cwiseMin(outer), inner.cwiseMax(outer), Material::painted_metal);
  }
}

/// One lane beside the middle, from the corridor's begin to its end.
std::vector<Eigen::Vector3d> lane(const std::vector<Piece>& pieces, double y) {
  std::vector<Eigen::Vector3d> way = {pieces.front().at(2.0, y, 0)};
  for (const Piece& piece : pieces) {
    const double end = piece.turn_after == 0.0 ? 2.0 : piece.turn_after * y;
    way.push_back(piece.at(piece.length - end, y, 0));
  }
  return way;
}

}  // namespace

Scene corridor(const SceneSeeds& seeds) {
  const LayoutDraws draw(seeds.layout, kPurposeCorridor);
  const Measures m = measures(draw);
  const std::vector<Piece> all = pieces(m, draw);
  Scene scene;
  TriangleMesh& mesh = scene.mesh;
  for (const Piece& piece : all) add_floor_and_ceiling(mesh, piece, m);
  for (const Piece& piece : all) {
    add_wall(mesh, piece, m, -1.0);
    add_wall(mesh, piece, m, 1.0);
  }
  add_radiators(mesh, all, m, CounterRandom(seeds.things, kPurposeCorridor));
  scene.route = lane(all, -kLane);
  scene.route.push_back(all.back().at(all.back().length - 1.5, 0.0, 0));
  const std::vector<Eigen::Vector3d> back = lane(all, kLane);
  scene.route.insert(scene.route.end(), back.rbegin(), back.rend());
  scene.route.push_back(all.front().at(1.5, 0.0, 0));
  scene.corner_rounding = 0.2;
  scene.robot = "trot";
  scene.view_ceiling = m.height - 0.1;
  scene.view_margin = 2.0;
  return scene;
}

}  // namespace surefoot::simulation
