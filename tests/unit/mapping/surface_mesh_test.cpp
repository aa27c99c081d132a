// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/surface_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace surefoot::mapping {
namespace {

/// What is seen from each of some places: all points from the nearest one that is on their side.
Piece seen_from(const std::vector<Eigen::Vector3f>& eyes) {
  Piece piece;
  piece.eyes = eyes;
  return piece;
}

void see(Piece& piece, double x, double y, double z, std::uint16_t eye = 0) {
  piece.points.emplace_back(Eigen::Vector3d(x, y, z).cast<float>());
  piece.seen_from.push_back(eye);
}

/// A room of 8 x 6 x 3 m, the LiDAR in it.
Piece room() {
  Piece piece = seen_from({{0.0F, 0.0F, 0.0F}});
  for (int i = -40; i <= 40; ++i) {
    for (int j = -30; j <= 30; ++j) {
      for (const double z : {-0.4, 2.6}) see(piece, 0.1 * i, 0.1 * j, z);
    }
  }
  for (double z = -0.3; z < 2.55; z += 0.1) {
    for (int i = -40; i <= 40; ++i) {
      for (const double y : {-3.0, 3.0}) see(piece, 0.1 * i, y, z);
    }
    for (int j = -29; j <= 29; ++j) {
      for (const double x : {-4.0, 4.0}) see(piece, x, 0.1 * j, z);
    }
  }
  return piece;
}

struct Triangle {
  Eigen::Vector3d middle, normal;
  double area = 0.0;
};

std::vector<Triangle> triangles_of(const SurfaceMesh& mesh) {
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d first = mesh.vertices[a];
    const Eigen::Vector3d second = mesh.vertices[b];
    const Eigen::Vector3d third = mesh.vertices[c];
    const Eigen::Vector3d cross = (second - first).cross(third - first);
    result.push_back({(first + second + third) / 3.0, cross.normalized(), 0.5 * cross.norm()});
  }
  return result;
}

double area_of(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& triangle : triangles_of(mesh)) sum += triangle.area;
  return sum;
}

/// [m] from the room's three pairs of sides, the nearest first.
std::array<double, 3> off_room(const Eigen::Vector3d& place) {
  const Eigen::Array3d off =
      (place.array() - Eigen::Array3d(0.0, 0.0, 1.1)).abs() - Eigen::Array3d(4.0, 3.0, 1.5);
  std::array<double, 3> distances = {std::abs(off[0]), std::abs(off[1]), std::abs(off[2])};
  std::sort(distances.begin(), distances.end());
  return distances;
}

/// Vertices lie on the sides; edges and corners may be cut by less than a cell.
void expect_on_room(const Eigen::Vector3d& place) {
  const std::array<double, 3> off = off_room(place);
  EXPECT_LT(off[0], off[1] < 0.5 ? 0.15 : 0.01) << place.transpose();
}

TEST(SurfaceMeshTest, ARoomIsClosedAndLooksInwards) {
  const SurfaceMesh mesh = draw_mesh({room()}, {});
  for (const Eigen::Vector3d& vertex : mesh.vertices) expect_on_room(vertex);
  double outwards = 0.0;
  for (const Triangle& triangle : triangles_of(mesh)) {
    const Eigen::Vector3d from_middle = triangle.middle - Eigen::Vector3d(0.0, 0.0, 1.1);
    if (triangle.normal.dot(from_middle) > 0.0) outwards += triangle.area;
  }
  EXPECT_LT(outwards, 0.1) << "m^2, in corners";
  EXPECT_NEAR(area_of(mesh), 2.0 * (8.0 * 6.0 + 8.0 * 3.0 + 6.0 * 3.0), 7.0);
  // Every edge is gone along once each way, but where three sides meet.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  }
  for (const auto& [edge, times] : edges) {
    const Eigen::Vector3d place = mesh.vertices[edge.first].cast<double>();
    if (off_room(place)[2] < 0.5) continue;
    EXPECT_EQ(times, 1) << place.transpose();
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << place.transpose();
  }
}

TEST(SurfaceMeshTest, HasNoVerticesThatNoTriangleUses) {
  Piece wall = seen_from({{0.0F, 0.0F, 0.0F}});  // whose border leaves cells without neighbours
  for (int i = -20; i <= 20; ++i) {
    for (int j = 0; j <= 15; ++j) see(wall, 3.0 + 0.02 * i, 0.1 * i, 0.1 * j - 0.02 * i);
  }
  const SurfaceMesh mesh = draw_mesh({wall}, {});
  std::set<std::uint32_t> used;
  for (const auto& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
  EXPECT_GT(used.size(), 100U);
  EXPECT_EQ(used.size(), mesh.vertices.size());
}

/// Elsewhere and turned it is the same room, however the grid lies in it.
TEST(SurfaceMeshTest, LiesWhereThePieceLies) {
  Piece piece = room();
  piece.T_world_piece.translation = {313.37, -271.83, 14.14};
  piece.T_world_piece.rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.1, 0.2, 1.0).normalized());
  const SurfaceMesh mesh = draw_mesh({piece}, {});
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    expect_on_room(piece.T_world_piece.inverse() * vertex);
  }
  EXPECT_NEAR(area_of(mesh), 180.0, 7.0);
}

/// As in coordinates of a country: floats are half a metre apart there.
TEST(SurfaceMeshTest, IsAsExactFarFromTheOrigin) {
  Piece piece = room();
  piece.T_world_piece.translation = {500'000.37, 5'400'000.17, 14.14};
  const SurfaceMesh mesh = draw_mesh({piece}, {});
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    expect_on_room(piece.T_world_piece.inverse() * vertex);
  }
  EXPECT_NEAR(area_of(mesh), 180.0, 7.0);
}

/// Blocks neither leave gaps between each other nor double what lies there.
TEST(SurfaceMeshTest, IsTheSameForBlocksOfAnySize) {
  const auto places = [](double block) {
    const SurfaceMesh mesh = draw_mesh({room()}, {.block = block});
    std::vector<std::array<float, 9>> sorted;
    for (const auto& triangle : mesh.triangles) {
      std::array<float, 9> corners{};
      for (std::size_t k = 0; k < 9; ++k) {
        corners[k] =
            static_cast<float>(mesh.vertices[triangle[k / 3]][static_cast<Eigen::Index>(k % 3)]);
      }
      sorted.push_back(corners);
    }
    std::sort(sorted.begin(), sorted.end());
    return std::pair(sorted, mesh.vertices.size());
  };
  const auto whole = places(50.0);
  EXPECT_GT(whole.second, 1000U);
  EXPECT_EQ(places(1.6), whole);
  EXPECT_EQ(places(3.0), whole);
}

TEST(SurfaceMeshTest, TellsHowFarItIs) {
  std::vector<std::size_t> told;
  const auto tell = [&](std::size_t done, std::size_t all) {
    told.push_back(done);
    EXPECT_LE(done, all);
    if (done == all) told.push_back(0);
  };
  static_cast<void>(draw_mesh({room()}, {.block = 5.0}, tell));
  ASSERT_GT(told.size(), 4U);
  EXPECT_EQ(told.front(), 1U);
  EXPECT_EQ(told.back(), 0U) << "all are done";
}

/// From both sides a wall of 0.2 m has two faces, each towards its own side.
TEST(SurfaceMeshTest, AThinWallKeepsBothFaces) {
  Piece piece = seen_from({{0.0F, -3.0F, 1.0F}, {0.0F, 3.0F, 1.0F}});
  for (double x = -3.0; x <= 3.0; x += 0.1) {
    for (double z = 0.0; z <= 2.0; z += 0.1) {
      see(piece, x, -0.1, z, 0);
      see(piece, x, 0.1, z, 1);
    }
  }
  double near = 0.0;
  double far = 0.0;
  for (const Triangle& triangle : triangles_of(draw_mesh({piece}, {}))) {
    if (std::abs(triangle.middle.x()) > 2.5 || std::abs(triangle.middle.z() - 1.0) > 0.6) continue;
    EXPECT_NEAR(std::abs(triangle.middle.y()), 0.1, 0.03);
    EXPECT_GT(triangle.normal.y() * triangle.middle.y(), 0.0);
    (triangle.middle.y() < 0.0 ? near : far) += triangle.area;
  }
  EXPECT_NEAR(near, 5.0 * 1.2, 0.6);
  EXPECT_NEAR(far, 5.0 * 1.2, 0.6);
}

/// Where nothing was seen there is nothing: a surface does not go on, and a hole stays one.
TEST(SurfaceMeshTest, EndsWhereNothingWasSeen) {
  Piece piece = seen_from({{0.0F, 0.0F, 1.0F}});
  for (double x = -3.0; x <= 3.0; x += 0.1) {
    for (double y = -3.0; y <= 3.0; y += 0.1) {
      if (std::max(std::abs(x), std::abs(y)) > 1.0) see(piece, x, y, 0.0);
    }
  }
  const SurfaceMesh mesh = draw_mesh({piece}, {});
  EXPECT_GT(area_of(mesh), 28.0);
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const double out = vertex.head<2>().lpNorm<Eigen::Infinity>();
    EXPECT_GT(out, 0.7);
    EXPECT_LT(out, 3.3);
    EXPECT_NEAR(vertex.z(), 0.0, 1e-3);
  }
}

/// A pole, a wire, a few points, or a plane that is looked along: no surface is told of these.
TEST(SurfaceMeshTest, WhatIsNoSurfaceHasNone) {
  EXPECT_TRUE(draw_mesh({}, {}).triangles.empty());
  EXPECT_TRUE(draw_mesh({Piece{}}, {}).triangles.empty());
  Piece piece = seen_from({{0.0F, 0.0F, 0.0F}});
  for (double z = -0.4; z < 3.0; z += 0.05) see(piece, 3.0 + 0.02 * std::sin(40.0 * z), 0.0, z);
  for (double y = -5.0; y < 5.0; y += 0.1) see(piece, -4.0, y, 2.5);
  for (int i = 0; i < 3; ++i) see(piece, 5.0, 5.0 + 0.1 * i, 0.1 * i * i);
  for (double x = 6.0; x < 9.0; x += 0.1) {
    for (double y = -2.0; y < -1.0; y += 0.1) see(piece, x, y, 0.0);  // level with the eye
  }
  EXPECT_TRUE(draw_mesh({piece}, {}).triangles.empty());
}

}  // namespace
}  // namespace surefoot::mapping
