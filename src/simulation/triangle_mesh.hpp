// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Triangles with a material each, and the shapes that scenes are built from.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace surefoot::simulation {

/// What a surface sends back at the LiDAR's wavelength: diffuse reflectivity in [0, 1].
/// Values after Kashani et al., "A review of LiDAR radiometric processing", Sensors 15 (2015) 11.
enum class Material : std::uint8_t {
  asphalt,
  concrete,
  brick,
  grass,
  foliage,
  bark,
  glass,
  painted_metal,
  cloth,
  rock,
  rubber,
  earth,
  blade,  ///< of grass, straw
  pane,   ///< clear glass: seen through, or a mirror where it is met at a low angle
};
[[nodiscard]] double reflectivity(Material material);
/// Whether a foot sinks through it: leaves, grass.
[[nodiscard]] bool is_soft(Material material);
/// For pictures: 0xRRGGBB.
[[nodiscard]] std::uint32_t color(Material material);

/// Vertices [m] and triangles. Every triangle is seen from both sides.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Matrix<std::uint32_t, 3, 1>> triangles;
  std::vector<Material> materials;  ///< one a triangle

  /// Four corners in order round the edge.
  void add_quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d, Material material);
  void add_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    Material material);
  /// Axis-parallel box between two opposite corners, turned about its own vertical axis by yaw.
  void add_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Material material,
               double yaw = 0.0);
  /// Upright cylinder or cone frustum with a lid; `sides` faces.
  void add_column(const Eigen::Vector3d& foot, double radius, double height, Material material,
                  int sides = 10, double top_radius = -1.0);
  /// Flat-sided ball.
  void add_ball(const Eigen::Vector3d& centre, double radius, Material material, int sides = 10);
  /// z = height(x, y) over the rectangle, in cells of about `cell` metres.
  void add_heightfield(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell,
                       const std::function<double(double, double)>& height, Material material);
  /// Appends another mesh.
  void add_mesh(const TriangleMesh& other);

 private:
  std::uint32_t add_vertex(const Eigen::Vector3d& vertex);
  void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c, Material material);
};

}  // namespace surefoot::simulation
