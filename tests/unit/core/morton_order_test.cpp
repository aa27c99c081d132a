// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/morton_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "support/random.hpp"

namespace surefoot {
namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<Eigen::Vector3f> points_anywhere(std::size_t count) {
  test::Random random(61);
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(random.vector(50.0).cast<float>());
  return points;
}

Indices all_of(const std::vector<Eigen::Vector3f>& points) {
  Indices indices(points.size());
  std::iota(indices.begin(), indices.end(), 0U);
  return indices;
}

double way_through(const std::vector<Eigen::Vector3f>& points, const Indices& indices) {
  double way = 0.0;
  for (std::size_t i = 1; i < indices.size(); ++i) {
    way += static_cast<double>((points[indices[i]] - points[indices[i - 1]]).norm());
  }
  return way;
}

TEST(MortonOrder, ItGoesThroughTheCornersOfACubeAxisByAxis) {
  std::vector<Eigen::Vector3f> corners;
  for (const int i : {5, 2, 7, 0, 3, 6, 1, 4}) {
    corners.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                         static_cast<float>(i >> 2));
  }
  Indices indices = all_of(corners);
  sort_along_morton_curve(corners, indices);
  EXPECT_EQ(indices, (Indices{3, 6, 1, 4, 7, 0, 5, 2}));
}

TEST(MortonOrder, EveryPointOnceAndNeighboursNear) {
  const auto points = points_anywhere(5000);
  const Indices before = all_of(points);
  Indices indices = before;
  sort_along_morton_curve(points, indices);
  EXPECT_TRUE(std::is_permutation(indices.begin(), indices.end(), before.begin(), before.end()));
  EXPECT_LT(way_through(points, indices), 0.15 * way_through(points, before));
}

TEST(MortonOrder, OnlyTheIndicesGivenInTheOrderTheyHadWhereACellHoldsSeveral) {
  auto points = points_anywhere(100);
  std::fill(points.begin() + 40, points.begin() + 60, points[40]);
  Indices indices;
  for (std::uint32_t i = 60; i-- > 30;) indices.push_back(i);
  sort_along_morton_curve(points, indices);
  EXPECT_EQ(indices.size(), 30U);
  const auto first = std::find(indices.begin(), indices.end(), 59U);
  ASSERT_LE(first - indices.begin(), 10);
  for (std::uint32_t i = 0; i < 20; ++i) EXPECT_EQ(*(first + i), 59 - i);
}

TEST(MortonOrder, NoneOneAndAllInOnePlace) {
  const std::vector<Eigen::Vector3f> same(3, Eigen::Vector3f(1.0F, 2.0F, 3.0F));
  for (const Indices& given : {Indices{}, Indices{2}, Indices{2, 0, 1}}) {
    Indices indices = given;
    sort_along_morton_curve(same, indices);
    EXPECT_EQ(indices, given);
  }
}

}  // namespace
}  // namespace surefoot
