// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Normals, eqs. (21)-(22), against Eigen on explicitly gathered neighbourhoods.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/decompositions.hpp"
#include "registration_fixture.hpp"

namespace surefoot {
namespace {

using test::Random;

/// The map's points in the 27 voxels about one.
std::vector<Eigen::Vector3d> gather(const std::vector<Eigen::Vector3d>& points,
                                    const VoxelIndex& voxel, double size) {
  std::vector<Eigen::Vector3d> neighbours;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3i index = (p / size).array().floor().cast<int>();
    if ((index - voxel).cwiseAbs().maxCoeff() <= 1) neighbours.push_back(p);
  }
  return neighbours;
}

struct Expected {
  Eigen::Vector3d eigenvalues;
  Eigen::Vector3d normal;
};

Expected eigen_of(const std::vector<Eigen::Vector3d>& neighbours) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : neighbours) mean += p / static_cast<double>(neighbours.size());
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : neighbours) C += (p - mean) * (p - mean).transpose();
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(C / static_cast<double>(neighbours.size()));
  return {eigen.values, eigen.vectors.col(0)};
}

void expect_surfaces(double size, const Eigen::Vector3d& shift, double tolerance) {
  PaperParameters config = test::step_config();
  config.map.voxel_size = size;
  const LocalMap map = test::make_map(test::room_points(3, 800), config, shift);
  const std::vector<Eigen::Vector3d> points = map.points();
  int compared = 0;
  for (std::size_t i = 0; i < points.size(); i += 7) {
    const VoxelIndex voxel = map.voxel_of(points[i]);
    const auto neighbours = gather(points, voxel, size);
    const Surface surface = map.surface(voxel);
    ASSERT_EQ(surface.neighbours, static_cast<int>(neighbours.size()));
    if (neighbours.size() < 3) continue;
    const Expected expected = eigen_of(neighbours);
    EXPECT_NEAR(surface.normal.norm(), 1.0, 1e-9);
    // The direction of the smallest eigenvalue is defined as well as that value stands apart.
    const double gap =
        (expected.eigenvalues[1] - expected.eigenvalues[0]) / expected.eigenvalues[2];
    if (gap < 1e-2) continue;
    EXPECT_LT(surface.normal.cross(expected.normal).norm(), tolerance / gap);
    EXPECT_NEAR(surface.planarity, gap, tolerance / gap);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(Surface, NormalsEqualEigenOnTheGatheredNeighbourhood) {
  expect_surfaces(1.0, Eigen::Vector3d::Zero(), 1e-6);
}

TEST(Surface, NormalsEqualEigenInSmallVoxels) {
  expect_surfaces(0.4, Eigen::Vector3d::Zero(), 1e-6);
}

TEST(Surface, NormalsEqualEigenTenKilometresAway) {
  // Voxels hold their points about their own corners, so that the distance costs no digits.
  expect_surfaces(1.0, {-10'240.0, 10'240.0, 512.0}, 1e-6);
}

TEST(Surface, NormalOfAPlaneIsItsNormalWithEitherSign) {
  Random random(5);
  PaperParameters config = test::step_config();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d n = random.unit_vector();
    const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    std::vector<Eigen::Vector3d> points;
    test::add_face(points, random, 3000, {0.0, 0.0, 0.0}, 4.0 * u, 4.0 * v);
    const LocalMap map = test::make_map(points, config);
    const Surface surface = map.surface(map.voxel_of(2.0 * u + 2.0 * v));
    EXPECT_NEAR(std::abs(surface.normal.dot(n)), 1.0, 1e-9);
    EXPECT_GT(surface.planarity, 0.2);
  }
}

TEST(Surface, PlanarityIsSmallForALineAndABall) {
  Random random(6);
  PaperParameters config = test::step_config();
  LocalMap line(config.map, 2.0), ball(config.map, 2.0);
  for (int i = 0; i < 300; ++i) {
    line.insert({0.01 * i, 0.5, 0.5});
    ball.insert({random.uniform(0, 3), random.uniform(0, 3), random.uniform(0, 3)});
  }
  EXPECT_LT(line.surface({1, 0, 0}).planarity, 0.01);
  EXPECT_LT(ball.surface({1, 1, 1}).planarity, 0.4);
}

TEST(Surface, FlatnessTellsPlanesAlsoLongOnesFromLinesAndBalls) {
  Random random(7);
  PaperParameters config = test::step_config();
  LocalMap plane(config.map, 2.0), strip(config.map, 2.0), ring(config.map, 2.0),
      ball(config.map, 2.0);
  for (int i = 0; i < 900; ++i) {
    const double x = random.uniform(0, 3), y = random.uniform(0, 3), z = random.uniform(0, 3);
    plane.insert({x, y, 1.5});
    strip.insert({x, 0.3 * y, 1.5});
    ring.insert({x, 1.5 + 0.01 * y, 1.5});  // one ring on a wall, 3 cm of noise, no height
    ball.insert({x, y, z});
  }
  EXPECT_GT(plane.surface({1, 1, 1}).flatness, 0.99);
  EXPECT_GT(strip.surface({1, 0, 1}).flatness, 0.9);
  EXPECT_LT(ring.surface({1, 1, 1}).flatness, 0.1);
  EXPECT_LT(ball.surface({1, 1, 1}).flatness, 0.5);
}

TEST(Surface, FewerThanThreePointsHaveNoSurface) {
  PaperParameters config = test::step_config();
  LocalMap map(config.map, 2.0);
  EXPECT_EQ(map.surface({0, 0, 0}).neighbours, 0);
  map.insert({0.1, 0.1, 0.1});
  map.insert({0.9, 0.1, 0.1});
  EXPECT_EQ(map.surface({0, 0, 0}).neighbours, 2);
  EXPECT_EQ(map.surface({0, 0, 0}).planarity, 0.0);
  EXPECT_EQ(map.surface({2, 0, 0}).neighbours, 0);
}

TEST(Surface, EqualPointsDoNotMakeNaN) {
  PaperParameters config = test::step_config();
  config.map.min_spacing = 0.0;
  LocalMap map(config.map, 2.0);
  for (int i = 0; i < 10; ++i) map.insert({0.3, 0.3, 0.3});
  const Surface surface = map.surface({0, 0, 0});
  EXPECT_TRUE(surface.normal.allFinite());
  EXPECT_TRUE(std::isfinite(surface.planarity));
  EXPECT_EQ(surface.flatness, 0.0);
}

}  // namespace
}  // namespace surefoot
