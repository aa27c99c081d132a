// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/voxel_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "methods/shared/cell_downsample.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

std::vector<Eigen::Vector3d> random_points(int count, double half_side, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(random.vector(half_side));
  return points;
}

int rounded(double scaled, CellRounding rounding) {
  return static_cast<int>(rounding == CellRounding::down ? std::floor(scaled) : std::trunc(scaled));
}

Eigen::Vector3i cell_of(const Eigen::Vector3d& point, double size, CellRounding rounding) {
  return {rounded(point.x() / size, rounding), rounded(point.y() / size, rounding),
          rounded(point.z() / size, rounding)};
}

constexpr CellRounding kRoundings[] = {CellRounding::down, CellRounding::to_zero};

TEST(CellIndex, RoundsDownOrToZero) {
  for (const double x : {-2.0, -1.5, -1.0, -0.2, 0.0, 0.2, 0.99, 1.0, 7.3}) {
    for (const CellRounding rounding : kRoundings) {
      EXPECT_EQ(cell_index(x, 0.5, rounding), rounded(x / 0.5, rounding)) << x;
    }
  }
  EXPECT_GT(cell_index(1e300, 0.5, CellRounding::down), 1000000);
  EXPECT_LT(cell_index(-1e300, 0.5, CellRounding::down), -1000000);
}

TEST(VoxelMap, NearestIsTheNearestOfTheCellAndItsNeighbours) {
  for (const CellRounding rounding : kRoundings) {
    VoxelMap map({0.7, 1000, 0.0, 100.0, rounding});
    const auto points = random_points(400, 3.0, 1);
    for (const auto& point : points) map.insert(point);
    for (const auto& query : random_points(300, 3.5, 2)) {
      for (const double limit : {0.3, 0.8, 10.0}) {
        const Eigen::Vector3d* expected = nullptr;
        for (const auto& point : points) {
          const Eigen::Vector3i apart =
              cell_of(point, 0.7, rounding) - cell_of(query, 0.7, rounding);
          if (apart.cwiseAbs().maxCoeff() > 1 || (point - query).norm() >= limit) continue;
          if (!expected || (point - query).norm() < (*expected - query).norm()) expected = &point;
        }
        const Eigen::Vector3d* found = map.nearest(query, limit);
        ASSERT_EQ(found == nullptr, expected == nullptr);
        if (found) {
          EXPECT_EQ(*found, *expected);
        }
      }
    }
  }
}

TEST(VoxelMap, FullCellsAndCloseNeighboursTakeNoMore) {
  VoxelMap map({1.0, 3, 0.2, 100.0});
  EXPECT_TRUE(map.empty());
  for (const double x : {0.1, 0.25, 0.35, 0.6, 0.95}) map.insert({x, 0.5, 0.5});
  const auto points = map.points();
  ASSERT_EQ(points.size(), 3U);  // 0.25 is too near to 0.1, 0.95 finds the cell full
  EXPECT_EQ(points[0].x(), 0.1);
  EXPECT_EQ(points[1].x(), 0.35);
  EXPECT_EQ(points[2].x(), 0.6);
}

TEST(VoxelMap, CellsLeaveByTheirFirstPointAndMayComeBack) {
  VoxelMap map({1.0, 5, 0.0, 10.0});
  for (int x = 0; x < 40; ++x) map.insert({x + 0.5, 0.5, 0.5});
  for (int step = 0; step < 18; ++step) {  // the first call takes all but ten, then one by one
    map.remove_far({static_cast<double>(step), 0.5, 0.5});
    for (int x = 0; x < 40; ++x) {
      const bool near = x + 0.5 < 10.0 && x + 0.5 > step - 10.0;
      EXPECT_EQ(map.cell({x, 0, 0}).size(), near ? 1U : 0U) << x << ' ' << step;
    }
  }
  map.insert({0.5, 0.5, 0.5});
  EXPECT_EQ(map.cell({0, 0, 0}).size(), 1U);
  map.remove_far({1000.0, 0.0, 0.0});
  EXPECT_TRUE(map.empty());
  EXPECT_TRUE(map.points().empty());
  EXPECT_EQ(map.nearest({0.5, 0.5, 0.5}, 1.0), nullptr);
}

std::uint32_t poor_hash(const VoxelIndex& cell) {
  return static_cast<std::uint32_t>(cell.x() & 3);  // everything collides
}
std::uint32_t fair_hash(const VoxelIndex& cell) {
  return static_cast<std::uint32_t>(cell.x() * 73856093 ^ cell.y() * 19349669);
}

TEST(CellDownsample, KeepsTheFirstPointOfEveryCellWhateverTheHash) {
  const auto points = random_points(3000, 5.0, 3);
  for (const CellRounding rounding : kRoundings) {
    using Key = std::tuple<int, int, int>;
    const auto key_of = [&](const Eigen::Vector3d& point) {
      const Eigen::Vector3i cell = cell_of(point, 0.9, rounding);
      return Key(cell.x(), cell.y(), cell.z());
    };
    std::map<Key, Eigen::Vector3d> first;
    for (const auto& point : points) first.emplace(key_of(point), point);
    for (const CellHash hash : {poor_hash, fair_hash}) {
      const auto thinned = cell_downsample(points, 0.9, rounding, hash);
      EXPECT_EQ(thinned.size(), first.size());
      for (const auto& point : thinned) EXPECT_EQ(point, first.at(key_of(point)));
    }
  }
  EXPECT_TRUE(cell_downsample({}, 1.0, CellRounding::down, fair_hash).empty());
}

std::uint32_t x_as_hash(const VoxelIndex& cell) { return static_cast<std::uint32_t>(cell.x()); }

TEST(CellDownsample, ComesInTheOrderOfTheTable) {
  // Eight slots for four points: home slots 3, 3 + 8, 1 and 4. The second is pushed to slot 4, from
  // where it cannot be driven by the one at home there, which goes on to 5.
  const std::vector<Eigen::Vector3d> points = {
      {3.5, 0.5, 0.5}, {11.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {4.5, 0.5, 0.5}};
  const auto thinned = cell_downsample(points, 1.0, CellRounding::down, x_as_hash);
  ASSERT_EQ(thinned.size(), 4U);
  EXPECT_EQ(thinned[0].x(), 1.5);
  EXPECT_EQ(thinned[1].x(), 3.5);
  EXPECT_EQ(thinned[2].x(), 11.5);
  EXPECT_EQ(thinned[3].x(), 4.5);
  // Inserted in another order, 11.5 drives 4.5 out of its slot.
  const auto again = cell_downsample({points[3], points[0], points[1], points[2]}, 1.0,
                                     CellRounding::down, x_as_hash);
  EXPECT_EQ(again[1].x(), 3.5);
  EXPECT_EQ(again[2].x(), 11.5);
  EXPECT_EQ(again[3].x(), 4.5);
}

TEST(CellDownsample, ATableThatExpectsFewCellsGrows) {
  // From one slot to two, four and eight: home slots 0, 3, 0 and 1 of eight.
  const std::vector<Eigen::Vector3d> points = {
      {8.5, 0.5, 0.5}, {3.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}};
  const auto first = first_of_cells(points, 1.0, CellRounding::down, x_as_hash, 0);
  EXPECT_EQ(first, (std::vector<std::uint32_t>{0, 2, 3, 1}));
  const auto many = random_points(3000, 5.0, 4);
  auto grown = first_of_cells(many, 0.9, CellRounding::down, fair_hash, 10);
  auto roomy = first_of_cells(many, 0.9, CellRounding::down, fair_hash, 3000);
  std::sort(grown.begin(), grown.end());
  std::sort(roomy.begin(), roomy.end());
  EXPECT_EQ(grown, roomy);
}

}  // namespace
}  // namespace surefoot
