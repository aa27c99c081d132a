// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_localizer.hpp"

#include <gtest/gtest.h>

#include <optional>
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

}  // namespace
}  // namespace surefoot::mapping
