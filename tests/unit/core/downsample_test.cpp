// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Thinning: which point of a cube stays.
#include "core/downsample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "support/random_cloud.hpp"

namespace surefoot {
namespace {

using test::Random;
using test::random_cloud;
using test::shuffle;

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
    shuffle(cloud, random);
    EXPECT_EQ(downsample(cloud, 0.5), expected);
  }
}

TEST(Downsample, NothingStaysNothing) { EXPECT_TRUE(downsample({}, 0.5).empty()); }

}  // namespace
}  // namespace surefoot
