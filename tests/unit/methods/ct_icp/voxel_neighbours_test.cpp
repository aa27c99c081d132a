// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/voxel_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.hpp"

namespace surefoot {
namespace {

TEST(VoxelNeighbours, AreTheNearestOfAllPoints) {
  test::Random random(1);
  for (const CellRounding rounding : {CellRounding::down, CellRounding::to_zero}) {
    VoxelMap map({0.5, 40, 0.0, 100.0, rounding});
    for (int i = 0; i < 4000; ++i) map.insert(random.vector(3.0));
    const std::vector<Eigen::Vector3d> all = map.points();
    for (const double radius : {0.4, 0.8, 1.3}) {
      const VoxelNeighbours neighbours(map, radius, 20);
      std::vector<VoxelNeighbours::Neighbour> found;
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d query = random.vector(3.2);
        std::vector<double> expected;
        for (const auto& point : all) {
          const double distance2 = (point - query).squaredNorm();
          if (distance2 <= radius * radius) expected.push_back(distance2);
        }
        std::sort(expected.begin(), expected.end());
        expected.resize(std::min<std::size_t>(expected.size(), 20));
        neighbours.find(query, found);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
          EXPECT_EQ(found[k].distance2, expected[k]);
          EXPECT_EQ((*found[k].point - query).squaredNorm(), expected[k]);
        }
      }
    }
  }
}

TEST(VoxelNeighbours, OfAnEmptyMapAreNone) {
  const VoxelMap map({0.5, 40, 0.0, 100.0});
  std::vector<VoxelNeighbours::Neighbour> found(3);
  VoxelNeighbours(map, 0.8, 20).find({1.0, 2.0, 3.0}, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace surefoot
