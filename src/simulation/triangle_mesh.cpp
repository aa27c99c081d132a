// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace surefoot::simulation {

namespace {

struct Surface {
  double reflectivity;
  std::uint32_t color;
};

/// In the order of Material.
constexpr std::array<Surface, 14> kSurfaces = {{{0.17, 0x5a5d63},
                                                {0.35, 0xb4b2ac},
                                                {0.40, 0xb5795a},
                                                {0.50, 0x7d9a55},
                                                {0.55, 0x4f7d3c},
                                                {0.30, 0x6f5540},
                                                {0.06, 0x7fa9c4},
                                                {0.45, 0x8893a3},
                                                {0.40, 0xc2554b},
                                                {0.30, 0x8d8478},
                                                {0.05, 0x2b2b2d},
                                                {0.25, 0x7a6650},
                                                {0.50, 0x93a04e},
                                                {0.80, 0xa9cfdd}}};

const Surface& surface(Material material) {
  return kSurfaces.at(static_cast<std::size_t>(material));
}

}  // namespace

double reflectivity(Material material) { return surface(material).reflectivity; }
bool is_soft(Material material) {
  return material == Material::foliage || material == Material::blade;
}
std::uint32_t color(Material material) { return surface(material).color; }

std::uint32_t TriangleMesh::add_vertex(const Eigen::Vector3d& vertex) {
  vertices.push_back(vertex.cast<float>());
  return static_cast<std::uint32_t>(vertices.size() - 1);
}

void TriangleMesh::add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, Material material) {
  triangles.emplace_back(a, b, c);
  materials.push_back(material);
}

void TriangleMesh::add_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, Material material) {
  const std::uint32_t first = add_vertex(a);
  add_vertex(b);
  add_vertex(c);
  add_face(first, first + 1, first + 2, material);
}

void TriangleMesh::add_quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& c, const Eigen::Vector3d& d, Material material) {
  const std::uint32_t first = add_vertex(a);
  add_vertex(b);
  add_vertex(c);
  add_vertex(d);
  add_face(first, first + 1, first + 2, material);
  add_face(first, first + 2, first + 3, material);
}

void TriangleMesh::add_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                           Material material, double yaw) {
  const Eigen::Vector3d centre = 0.5 * (low + high);
  const Eigen::Vector3d half = 0.5 * (high - low);
  std::array<Eigen::Vector3d, 8> corner;
  for (std::size_t i = 0; i < 8; ++i) {
    const double x = (i & 1U) != 0 ? half.x() : -half.x();
    const double y = (i & 2U) != 0 ? half.y() : -half.y();
    const double z = (i & 4U) != 0 ? half.z() : -half.z();
    corner[i] = centre + Eigen::Vector3d(std::cos(yaw) * x - std::sin(yaw) * y,
                                         std::sin(yaw) * x + std::cos(yaw) * y, z);
  }
  add_quad(corner[0], corner[2], corner[3], corner[1], material);
  add_quad(corner[4], corner[5], corner[7], corner[6], material);
  add_quad(corner[0], corner[1], corner[5], corner[4], material);
  add_quad(corner[2], corner[6], corner[7], corner[3], material);
  add_quad(corner[0], corner[4], corner[6], corner[2], material);
  add_quad(corner[1], corner[3], corner[7], corner[5], material);
}

void TriangleMesh::add_column(const Eigen::Vector3d& foot, double radius, double height,
                              Material material, int sides, double top_radius) {
  const double upper = top_radius < 0.0 ? radius : top_radius;
  const auto on_ring = [&](int side, double r, double z) {
    const double angle = 2.0 * std::numbers::pi * side / sides;
    return Eigen::Vector3d(foot + Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z));
  };
  const Eigen::Vector3d top = foot + Eigen::Vector3d(0.0, 0.0, height);
  for (int side = 0; side < sides; ++side) {
    add_quad(on_ring(side, radius, 0.0), on_ring(side + 1, radius, 0.0),
             on_ring(side + 1, upper, height), on_ring(side, upper, height), material);
    if (upper > 0.0) {
      add_triangle(on_ring(side, upper, height), on_ring(side + 1, upper, height), top, material);
    }
  }
}

void TriangleMesh::add_ball(const Eigen::Vector3d& centre, double radius, Material material,
                            int sides) {
  const int rows = std::max(3, sides / 2);
  const auto at = [&](int row, int side) {
    const double polar = std::numbers::pi * row / rows;
    const double around = 2.0 * std::numbers::pi * side / sides;
    return Eigen::Vector3d(centre + radius * Eigen::Vector3d(std::sin(polar) * std::cos(around),
                                                             std::sin(polar) * std::sin(around),
                                                             std::cos(polar)));
  };
  for (int row = 0; row < rows; ++row) {
    for (int side = 0; side < sides; ++side) {
      add_quad(at(row, side), at(row + 1, side), at(row + 1, side + 1), at(row, side + 1),
               material);
    }
  }
}

void TriangleMesh::add_heightfield(const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                                   double cell, const std::function<double(double, double)>& height,
                                   Material material) {
  const int columns = std::max(1, static_cast<int>(std::lround((high.x() - low.x()) / cell)));
  const int rows = std::max(1, static_cast<int>(std::lround((high.y() - low.y()) / cell)));
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double x = low.x() + (high.x() - low.x()) * column / columns;
      const double y = low.y() + (high.y() - low.y()) * row / rows;
      add_vertex({x, y, height(x, y)});
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column < static_cast<std::uint32_t>(columns); ++column) {
      const std::uint32_t corner = first + row * stride + column;
      add_face(corner, corner + 1, corner + stride + 1, material);
      add_face(corner, corner + stride + 1, corner + stride, material);
    }
  }
}

void TriangleMesh::add_mesh(const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(vertices.size());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& triangle : other.triangles) {
    triangles.emplace_back(triangle.x() + offset, triangle.y() + offset, triangle.z() + offset);
  }
  materials.insert(materials.end(), other.materials.begin(), other.materials.end());
}

}  // namespace surefoot::simulation
