// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mapping/surface_mesh.hpp"
#include "simulation/ray_caster.hpp"
#include "unit/mapping/scene_walk.hpp"

namespace surefoot::mapping {
namespace {

constexpr std::uint64_t kLayout = 5;

std::vector<Piece> pieces_of(const test::SceneWalk& walk) {
  PieceBuilder builder{PieceOptions{}};
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    if (auto piece = builder.add(walk.scans[i], walk.points[i])) pieces.push_back(*piece);
  }
  if (auto piece = builder.finish()) pieces.push_back(*piece);
  return pieces;
}

/// Of each triangle: how far along its normal the scene's nearest surface that faces it lies [m]; 1
/// if there is none within a metre.
std::vector<double> off_scene(const SurfaceMesh& mesh, const simulation::RayCaster& rays) {
  std::vector<simulation::Ray> beams;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f first = mesh.vertices[a].cast<float>();
    const Eigen::Vector3f second = mesh.vertices[b].cast<float>();
    const Eigen::Vector3f third = mesh.vertices[c].cast<float>();
    const Eigen::Vector3f normal = (second - first).cross(third - first).normalized();
    const Eigen::Vector3f middle = (first + second + third) / 3.0F;
    // A wall's other face lies 0.2 m behind: the surface is looked for from in front.
    beams.push_back({middle + 0.1F * normal, -normal, 0.0F});
  }
  std::vector<simulation::Hit> hits(beams.size());
  rays.cast(beams, 1.1F, hits);
  std::vector<double> off;
  for (const simulation::Hit& hit : hits) {
    off.push_back(hit.valid() ? std::abs(static_cast<double>(hit.distance) - 0.1) : 1.0);
  }
  std::sort(off.begin(), off.end());
  return off;
}

/// Ranges with a noise of 0.01 m, 0.2 m cells; the rest are edges, which are rounded, and leaves.
TEST(SceneMesh, LiesOnWhatWasWalkedBy) {
  const SurfaceMesh mesh =
      draw_mesh(pieces_of(test::walk_through("campus", kLayout, {.length = 60.0})), {});
  const simulation::RayCaster rays(simulation::build_scene("campus", {kLayout, kLayout}));
  const std::vector<double> off = off_scene(mesh, rays);
  ASSERT_GT(off.size(), 100'000U);
  const auto at = [&](double share) {
    return off[static_cast<std::size_t>(share * static_cast<double>(off.size()))];
  };
  // Measured: 0.0015, 0.038, 0.080 m.
  EXPECT_LT(at(0.5), 0.003);
  EXPECT_LT(at(0.8), 0.06);
  EXPECT_LT(at(0.9), 0.12);
}

}  // namespace
}  // namespace surefoot::mapping
