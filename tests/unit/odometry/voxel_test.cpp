// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Voxel indices and keys, the hash table, thinning.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "odometry/downsample.hpp"
#include "odometry/voxel_key.hpp"
#include "odometry/voxel_table.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

TEST(VoxelKey, IndexIsTheFloor) {
  EXPECT_EQ(voxel_index(0.0, 1.0), 0);
  EXPECT_EQ(voxel_index(-1e-9, 1.0), -1);
  EXPECT_EQ(voxel_index(-1.0, 1.0), -1);
  EXPECT_EQ(voxel_index(-1.0001, 1.0), -2);
  EXPECT_EQ(voxel_index(2.99, 2.0), 5);
}

TEST(VoxelKey, KeysDifferOverAMillionVoxelsEachWay) {
  std::set<std::uint64_t> keys;
  const int ends[] = {-1'048'576, -1'000'000, -1, 0, 1, 1'000'000, 1'048'575};
  for (const int x : ends) {
    for (const int y : ends) {
      for (const int z : ends) keys.insert(voxel_key({x, y, z}));
    }
  }
  EXPECT_EQ(keys.size(), 343U);
}

TEST(VoxelTable, BehavesLikeAMapWhileItGrows) {
  Random random(1);
  VoxelTable table;
  std::map<std::uint64_t, std::uint32_t> expected;
  for (std::uint32_t i = 0; i < 50'000; ++i) {
    const std::uint64_t key = random.below(30'000);  // many twice
    const auto [index, inserted] = table.find_or_insert(key, i);
    const auto [place, is_new] = expected.emplace(key, i);
    ASSERT_EQ(inserted, is_new);
    ASSERT_EQ(index, place->second);
  }
  for (std::uint64_t key = 0; key < 40'000; ++key) {
    const auto place = expected.find(key);
    ASSERT_EQ(table.find(key), place == expected.end() ? VoxelTable::kNone : place->second);
  }
  table.clear();
  EXPECT_EQ(table.find(expected.begin()->first), VoxelTable::kNone);
  EXPECT_TRUE(table.find_or_insert(7, 3).second);
}

std::vector<Eigen::Vector3f> random_cloud(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Eigen::Vector3f> cloud;
  for (int i = 0; i < count; ++i) cloud.emplace_back(random.vector(4.0).cast<float>());
  return cloud;
}

using Cube = std::tuple<int, int, int>;
Cube cube_of(const Eigen::Vector3f& p, double voxel) {
  const Eigen::Vector3i i = (p.cast<double>() / voxel).array().floor().cast<int>();
  return {i.x(), i.y(), i.z()};
}

TEST(Downsample, KeepsOnePointOfEveryCubeTheOneNearestToItsCentre) {
  constexpr double kVoxel = 0.5;  // exact in binary: both ways of dividing floor alike
  const auto cloud = random_cloud(2, 8000);
  std::map<Cube, double> nearest;
  const auto to_centre = [&](const Eigen::Vector3f& p) {
    const auto [x, y, z] = cube_of(p, kVoxel);
    const Eigen::Vector3d centre = kVoxel * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
    return (p.cast<double>() - centre).norm();
  };
  for (const auto& p : cloud) {
    const auto place = nearest.emplace(cube_of(p, kVoxel), to_centre(p)).first;
    place->second = std::min(place->second, to_centre(p));
  }
  const auto thinned = downsample(cloud, kVoxel);
  EXPECT_EQ(thinned.size(), nearest.size());
  std::set<Cube> seen;
  for (const auto& p : thinned) {
    EXPECT_TRUE(seen.insert(cube_of(p, kVoxel)).second);
    EXPECT_NEAR(to_centre(p), nearest.at(cube_of(p, kVoxel)), 1e-6);
    EXPECT_NE(std::find(cloud.begin(), cloud.end(), p), cloud.end());
  }
}

TEST(Downsample, OrderOfThePointsDoesNotChangeABit) {
  auto cloud = random_cloud(3, 5000);
  // Points equally far from a cube's centre, and points twice.
  for (const float x : {0.1F, 0.4F}) cloud.emplace_back(x, 0.25F, 0.25F);
  cloud.insert(cloud.end(), cloud.begin(), cloud.begin() + 500);
  const auto expected = downsample(cloud, 0.5);
  Random random(4);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = cloud.size(); i > 1; --i) std::swap(cloud[i - 1], cloud[random.below(i)]);
    EXPECT_EQ(downsample(cloud, 0.5), expected);
  }
}

TEST(Downsample, NothingStaysNothing) { EXPECT_TRUE(downsample({}, 0.5).empty()); }

}  // namespace
}  // namespace surefoot
