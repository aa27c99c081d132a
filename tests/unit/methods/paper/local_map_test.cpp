// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The local map: exact neighbours and clearance, floor indices, capacity, spacing, bounded memory.
#include "methods/paper/local_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

PaperParameters::Map map_config(double voxel_size) {
  PaperParameters::Map config = test::default_parameters<PaperParameters>().map;
  config.voxel_size = voxel_size;
  config.points_per_voxel = 20;
  config.min_spacing = 0.0;
  return config;
}

/// Distances of all points from a place, nearest first, and infinity behind them.
std::vector<double> brute_force(const std::vector<Eigen::Vector3d>& points,
                                const Eigen::Vector3d& place) {
  std::vector<double> distances;
  for (const Eigen::Vector3d& point : points) distances.push_back((point - place).norm());
  std::sort(distances.begin(), distances.end());
  distances.resize(points.size() + Nearby::kMost + 1, std::numeric_limits<double>::infinity());
  return distances;
}

/// Coordinates are floats about a voxel's corner: 1e-7 of a metre or two.
constexpr double kRounding = 1e-6;

/// The answer against all points: the right ones, in order, and nothing nearer than `clearance`.
void expect_exact(const Nearby& nearby, const std::vector<Eigen::Vector3d>& stored,
                  const Eigen::Vector3d& place, double radius) {
  const std::vector<double> expected = brute_force(stored, place);
  int within = 0;
  while (within < Nearby::kMost && expected[within] < radius) ++within;
  // A point on the very edge of the radius may count as either side of it.
  if (nearby.count != within) {
    ASSERT_NEAR(expected[std::min(nearby.count, within)], radius, kRounding);
    ASSERT_LE(std::abs(nearby.count - within), 1);
  }
  for (int i = 0; i < nearby.count; ++i) {
    const Eigen::Vector3d offset = nearby.offsets[i].cast<double>();
    ASSERT_NEAR(offset.norm(), expected[i], kRounding);
    ASSERT_LT(brute_force(stored, place + offset).front(), kRounding);
    for (int j = 0; j < i; ++j) {  // the same point is not named twice
      ASSERT_GT((offset - nearby.offsets[j].cast<double>()).norm(), 0.0);
    }
    if (i == 0) continue;
    ASSERT_LE(nearby.offsets[i - 1].norm(), nearby.offsets[i].norm() * 1.000001F);
  }
  const double clearance = static_cast<double>(nearby.clearance);
  ASSERT_GE(expected[nearby.count], clearance - kRounding);
  // As much is promised as can be: up to the radius, or up to the last of a full list.
  ASSERT_NEAR(clearance, std::min(radius, expected[Nearby::kMost - 1]), kRounding);
}

void expect_nearby_is_exact(double voxel_size, double max_radius, const Eigen::Vector3d& centre,
                            int points, std::uint64_t seed) {
  Random random(seed);
  LocalMap map(map_config(voxel_size), max_radius);
  for (int i = 0; i < points; ++i) map.insert(centre + random.vector(6.0));
  const auto stored = map.points();
  int some = 0;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d place = centre + random.vector(8.0);
    // Radii up to the one that the map was made for.
    const double radius = i % 3 == 0 ? random.uniform(0.0, max_radius) : max_radius;
    const Nearby nearby = map.nearby(place, radius);
    ASSERT_NO_FATAL_FAILURE(expect_exact(nearby, stored, place, radius));
    some += nearby.count > 0 ? 1 : 0;
  }
  EXPECT_GT(some, 30);
}

TEST(LocalMap, NearbyEqualsBruteForceWithinOneVoxel) {
  expect_nearby_is_exact(1.0, 1.0, Eigen::Vector3d::Zero(), 2000, 1);
  expect_nearby_is_exact(1.0, 0.45, Eigen::Vector3d::Zero(), 3000, 2);
}

TEST(LocalMap, NearbyEqualsBruteForceBeyondOneVoxel) {
  expect_nearby_is_exact(1.0, 2.0, Eigen::Vector3d::Zero(), 200, 3);
  expect_nearby_is_exact(0.5, 2.3, Eigen::Vector3d::Zero(), 600, 4);
  expect_nearby_is_exact(0.7, 3.0, Eigen::Vector3d::Zero(), 20, 5);
}

TEST(LocalMap, NearbyEqualsBruteForceUpToItsLargestReach) {
  const double reach = LocalMap::kMaxReach * 0.25;
  expect_nearby_is_exact(0.25, reach, Eigen::Vector3d::Zero(), 30, 11);
  expect_nearby_is_exact(0.25, reach, Eigen::Vector3d::Zero(), 1000, 12);
}

TEST(LocalMap, NearbyEqualsBruteForceFarFromTheOrigin) {
  expect_nearby_is_exact(1.0, 2.0, {-40.0, -30.0, -20.0}, 500, 6);
  expect_nearby_is_exact(1.0, 2.0, {10'000.3, -10'000.7, 500.1}, 500, 7);
}

TEST(LocalMap, NearbyAtAPointsOwnPlaceNamesItFirst) {
  Random random(13);
  LocalMap map(map_config(1.0), 2.0);
  for (int i = 0; i < 500; ++i) map.insert(random.vector(3.0));
  for (const Eigen::Vector3d& point : map.points()) {
    const Nearby nearby = map.nearby(point, 0.5);
    ASSERT_GE(nearby.count, 1);
    EXPECT_LT(nearby.offsets[0].norm(), 1e-6F);
  }
}

TEST(LocalMap, InAnEmptyMapNothingIsNearby) {
  LocalMap map(map_config(1.0), 2.0);
  EXPECT_TRUE(map.empty());
  EXPECT_EQ(map.nearby({0.0, 0.0, 0.0}, 2.0).count, 0);
  EXPECT_FLOAT_EQ(map.nearby({0.0, 0.0, 0.0}, 2.0).clearance, 2.0F);
  map.insert({0.5, 0.5, 0.5});
  EXPECT_FALSE(map.empty());
  EXPECT_EQ(map.nearby({0.0, 0.0, 0.0}, 2.0).count, 1);
  map.clear();
  EXPECT_TRUE(map.empty());
  EXPECT_EQ(map.nearby({0.5, 0.5, 0.5}, 2.0).count, 0);
}

TEST(LocalMap, VoxelsAreEquallyLargeOnBothSidesOfZero) {
  const LocalMap map(map_config(0.5), 1.0);
  EXPECT_EQ(map.voxel_of({-0.01, 0.0, 0.01}), VoxelIndex(-1, 0, 0));
  EXPECT_EQ(map.voxel_of({-0.5, -0.51, -1.0}), VoxelIndex(-1, -2, -2));
  EXPECT_EQ(map.voxel_of({0.49, 0.5, 0.99}), VoxelIndex(0, 1, 1));
}

TEST(LocalMap, AFullVoxelTakesNoMore) {
  PaperParameters::Map config = map_config(1.0);
  for (const int capacity : {1, 3, 4, 5, 17}) {  // around the width of the vector search
    config.points_per_voxel = capacity;
    LocalMap map(config, 1.0);
    for (int i = 0; i < 40; ++i) map.insert({0.01 + 0.02 * i, 0.5, -0.5});
    EXPECT_EQ(map.points().size(), static_cast<std::size_t>(capacity));
    EXPECT_EQ(map.voxels(), 1U);
    EXPECT_EQ(map.surface({0, 0, -1}).neighbours, capacity);
  }
}

TEST(LocalMap, PointsOfAVoxelKeepTheirDistance) {
  Random random(8);
  PaperParameters::Map config = map_config(1.0);
  config.min_spacing = 0.2;
  config.points_per_voxel = 60;
  LocalMap map(config, 1.0);
  for (int i = 0; i < 3000; ++i) map.insert(random.vector(2.0));
  const auto points = map.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (map.voxel_of(points[i]) != map.voxel_of(points[j])) continue;
      EXPECT_GE((points[i] - points[j]).norm(), 0.2 - 1e-6);
    }
  }
  EXPECT_GT(points.size(), 64U * 10);
}

TEST(LocalMap, ForgetsWhatIsFarAndKeepsWhatIsNear) {
  Random random(9);
  LocalMap map(map_config(1.0), 2.0);
  map.remove_far(Eigen::Vector3d::Zero(), 20.0);
  for (int i = 0; i < 5000; ++i) map.insert(random.vector(30.0));
  const Eigen::Vector3d sensor(10.0, 0.0, 0.0);
  const auto before = map.points();
  map.remove_far(sensor, 20.0);
  const auto after = map.points();
  const auto centre = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return map.voxel_of(p).cast<double>().array() + 0.5;
  };
  std::size_t expected = 0;
  for (const auto& p : before) expected += (centre(p) - sensor).norm() <= 20.0 ? 1 : 0;
  EXPECT_EQ(after.size(), expected);
  EXPECT_LT(after.size(), before.size());
  for (const auto& p : after) {
    ASSERT_LE((centre(p) - sensor).norm(), 20.0);
    const Nearby nearby = map.nearby(p, 0.01);
    ASSERT_GE(nearby.count, 1);
    EXPECT_LT(nearby.offsets[0].norm(), 1e-6F);
  }
}

TEST(LocalMap, MemoryStaysBoundedOnALongWay) {
  Random random(10);
  LocalMap map(map_config(1.0), 1.0);
  std::size_t most = 0;
  for (int step = 0; step < 500; ++step) {
    const Eigen::Vector3d sensor(2.0 * step, -1.0 * step, 0.1 * step);
    map.remove_far(sensor, 10.0);
    for (int i = 0; i < 200; ++i) map.insert(sensor + random.vector(5.0));
    most = std::max(most, map.voxels());
  }
  // Voxels with their centre in a ball of 10 m: 4,189; and one scan's cube of 11^3 beyond.
  EXPECT_LE(most, 4189U + 1331U);
}

}  // namespace
}  // namespace surefoot
