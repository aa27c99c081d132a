// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "mapping/finished_walk.hpp"
#include "mapping/walk_mapper.hpp"

namespace surefoot::mapping {
namespace {

/// A room that is like no other from x = -20 to 0, and a bare corridor on from there.
std::vector<Eigen::Vector3f> room_and_corridor() {
  constexpr float kSpacing = 0.2F;
  std::vector<Eigen::Vector3f> points;
  const auto wall = [&](const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const float length = (to - from).norm();
    for (float s = 0.0F; s < length; s += kSpacing) {
      const Eigen::Vector2f at = from + s / length * (to - from);
      for (float z = -0.4F; z < 2.6F; z += kSpacing) points.emplace_back(at.x(), at.y(), z);
    }
  };
  for (float x = -20.0F; x < 60.0F; x += kSpacing) {
    const float half = x < 0.0F ? 8.0F : 1.5F;
    for (float y = -half; y < half; y += kSpacing) points.emplace_back(x, y, -0.4F);
  }
  for (const float side : {-1.0F, 1.0F}) {
    wall({-20.0F, 8.0F * side}, {0.0F, 8.0F * side});
    wall({0.0F, 1.5F * side}, {0.0F, 8.0F * side});
    wall({0.0F, 1.5F * side}, {60.0F, 1.5F * side});
  }
  wall({-20.0F, -8.0F}, {-20.0F, 8.0F});
  wall({-13.0F, 3.0F}, {-10.0F, 6.0F});
  wall({-6.0F, -8.0F}, {-6.0F, -4.0F});
  wall({-3.0F, 4.0F}, {-2.0F, 4.0F});
  return points;
}

/// What is seen from there, all around for fifteen metres.
DeskewedScan seen_from(const std::vector<Eigen::Vector3f>& scene, float x) {
  constexpr float kRange = 15.0F;
  const Eigen::Vector3f eye(x, 0.0F, 0.0F);
  DeskewedScan scan;
  for (const Eigen::Vector3f& point : scene) {
    if ((point - eye).squaredNorm() < kRange * kRange) scan.points.push_back(point - eye);
  }
  return scan;
}

constexpr float kFrom = -16.0F, kTo = 40.0F, kStep = 0.5F;

PlacedScan placed(float x, const Pose& T_world_scene) {
  PlacedScan scan;
  scan.stamp_ns = static_cast<std::int64_t>(1e9 * (x - kFrom));
  scan.T_world_lidar = T_world_scene * Pose{Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}};
  scan.covariance = 1e-8 * Matrix6::Identity();
  return scan;
}

SavedMap map_of(const std::vector<Eigen::Vector3f>& scene) {
  MapperOptions options;
  options.close_loops = false;
  WalkMapper mapper(options);
  for (float x = kFrom; x < kTo; x += kStep) mapper.add(placed(x, Pose{}), seen_from(scene, x));
  mapper.finish();
  return saved_map_of(mapper);
}

// Nothing in it tells how far along it the robot is: that stays what the odometry says.
TEST(MapLocalizer, ACorridorMovesNobodyAlongIt) {
  const std::vector<Eigen::Vector3f> scene = room_and_corridor();
  MapLocalizer localizer(map_of(scene), {});
  const Pose T_world_scene{so3_exp({0.0, 0.0, 0.3}), {3.0, -2.0, 0.0}};
  std::optional<Pose> at_corridor;
  for (float x = kFrom; x < kTo; x += kStep) {
    localizer.add(placed(x, T_world_scene), seen_from(scene, x));
    const std::optional<Pose> found = localizer.T_map_world();
    if (x < 24.0F) continue;
    ASSERT_TRUE(found);
    if (!at_corridor) at_corridor = found;
    EXPECT_EQ(found->translation, at_corridor->translation);
    EXPECT_LT((*found * T_world_scene).translation.norm(), 0.01);
  }
}

/// A localizer that has found its place in the room, at x.
void find_room(MapLocalizer& localizer, const std::vector<Eigen::Vector3f>& scene, float to) {
  for (float x = kFrom; x <= to; x += kStep) localizer.add(placed(x, Pose{}), seen_from(scene, x));
  ASSERT_TRUE(localizer.T_map_world()) << localizer.message();
}

/// The odometry goes down the corridor, and what is seen is the room.
TEST(MapLocalizer, IsLostWhereTheMapWasNotConfirmedForSomeMetres) {
  const std::vector<Eigen::Vector3f> scene = room_and_corridor();
  const SavedMap map = map_of(scene);
  for (const double lost_after : {4.0, 20.0}) {
    LocalizerOptions options;
    options.lost_after = lost_after;
    MapLocalizer localizer(map, options);
    constexpr float kFound = 8.0F;
    find_room(localizer, scene, kFound);
    float x = kFound;
    while (localizer.T_map_world() && x < 60.0F) {
      localizer.add(placed(x += kStep, Pose{}), seen_from(scene, -12.0F));
    }
    EXPECT_FALSE(localizer.T_map_world());
    const double last_confirmed = kFound - options.check_every;
    EXPECT_GT(x, last_confirmed + lost_after);
    EXPECT_LT(x, kFound + lost_after + options.check_again + 2.0 * kStep);
  }
}

TEST(MapLocalizer, ScansThatTheOdometryIsNotSureOfTellNoPlace) {
  const std::vector<Eigen::Vector3f> scene = room_and_corridor();
  MapLocalizer localizer(map_of(scene), {});
  for (float x = kFrom; x < -4.0F; x += kStep) {
    PlacedScan scan = placed(x, Pose{});
    scan.covariance = Matrix6::Identity();
    localizer.add(scan, seen_from(scene, x));
    ASSERT_FALSE(localizer.T_map_world());
  }
  EXPECT_EQ(localizer.message(), "not found yet: the odometry is not sure of its way");
}

/// The room, but for what stands in its middle.
std::vector<Eigen::Vector3f> without_things(std::vector<Eigen::Vector3f> scene) {
  std::erase_if(scene, [](const Eigen::Vector3f& point) {
    return point.x() > -19.0F && point.x() < -1.0F && std::abs(point.y()) < 7.5F &&
           point.z() > -0.3F;
  });
  return scene;
}

/// A pose at which walls were missing is not believed, until it is one in another world.
TEST(MapLocalizer, WhereTheOdometryBeganAnewNothingSpeaksAgainstAPlaceAnyMore) {
  const std::vector<Eigen::Vector3f> scene = room_and_corridor();
  const std::vector<Eigen::Vector3f> bare = without_things(scene);
  const SavedMap map = map_of(scene);
  constexpr float kHere = -6.0F;
  LocalizerOptions options;
  options.agreement.missing_way = 1e3;
  options.agreement.missing = 0.04;
  for (const bool anew : {false, true}) {
    MapLocalizer localizer(map, options);
    for (int i = 0; i < 15; ++i) localizer.add(placed(kHere, Pose{}), seen_from(bare, kHere));
    ASSERT_FALSE(localizer.T_map_world());
    for (float x = kHere; x < 20.0F && !localizer.T_map_world(); x += kStep) {
      PlacedScan scan = placed(x, Pose{});
      scan.restarted = anew && x == kHere;
      localizer.add(scan, seen_from(scene, x));
    }
    EXPECT_EQ(localizer.T_map_world().has_value(), anew) << localizer.message();
  }
}

}  // namespace
}  // namespace surefoot::mapping
