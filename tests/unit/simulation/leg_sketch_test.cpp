// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/leg_sketch.hpp"

#include <gtest/gtest.h>

#include "simulation/scene_view.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

TEST(LegSketchTest, FeetStandStillOnTheGroundAndLinksKeepTheirLength) {
  const Scene scene = room();
  const RayCaster rays(scene);
  const GaitModel gait = gait_model("trot");
  const Motion motion = make_motion(scene, rays, gait, 8.0, 3, kMount);
  const LegSketch sketch(gait, motion, rays, 3);
  constexpr double kStep = 0.005;
  std::size_t standing = 0;
  std::size_t swinging = 0;
  for (double time = 4.0; time < 6.0; time += kStep) {
    const std::vector<Leg> legs = sketch.at(time, motion.T_map_body(time));
    const std::vector<Leg> next = sketch.at(time + kStep, motion.T_map_body(time + kStep));
    ASSERT_EQ(legs.size(), 4U);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      EXPECT_NEAR((legs[i].knee - legs[i].hip).norm(), 0.213, 0.02);
      EXPECT_NEAR((legs[i].knee - legs[i].foot).norm(), 0.213, 0.02);
      EXPECT_GT(legs[i].foot.z(), -1e-6);
      EXPECT_LT(legs[i].foot.z(), 0.081);
      const double moved = (next[i].foot - legs[i].foot).norm();
      if (moved < 1e-9) {
        ++standing;
        EXPECT_NEAR(legs[i].foot.z(), 0.0, 1e-5);
      } else {
        ++swinging;
        EXPECT_LT(moved, 5.0 * kStep);  // no jumps: 5 m/s
      }
    }
  }
  EXPECT_NEAR(static_cast<double>(standing) / static_cast<double>(standing + swinging), 0.5, 0.05);
}

TEST(LegSketchTest, WhatHasNoFootfallsHasNoLegs) {
  const Scene scene = room();
  const RayCaster rays(scene);
  const GaitModel gait = gait_model("wheel");
  const Motion motion = make_motion(scene, rays, gait, 3.0, 3, kMount);
  EXPECT_TRUE(LegSketch(gait, motion, rays, 3).at(1.0, motion.T_map_body(1.0)).empty());
}

TEST(SceneViewTest, RaysPassThroughThePointsOfTheirPixelsAndWallsHide) {
  Scene scene;
  scene.mesh.add_box({-1, -1, 0}, {1, 1, 2}, Material::concrete);
  const RayCaster rays(scene);
  const Eigen::Vector3d center(0.5, 0.2, 0.0);
  const SceneView view(scene, center, 12.0, 300, 200);
  EXPECT_LT((view.pixel(center) - Eigen::Vector2d(150, 100)).norm(), 1e-9);
  const Eigen::Vector3d point(-2.0, 1.5, 0.7);
  const Ray ray = view.ray(view.pixel(point).x(), view.pixel(point).y());
  const Eigen::Vector3d across = point - ray.origin.cast<double>();
  const Eigen::Vector3d direction = ray.direction.cast<double>();
  EXPECT_LT((across - across.dot(direction) * direction).norm(), 1e-3);
  // Seen from the south and above: the roof, a point before the south wall, one behind the box.
  const std::vector<bool> seen = view.visible({{0, 0, 2}, {0, -3, 0.5}, {-0.5, 1.3, 0.2}}, rays);
  EXPECT_TRUE(seen[0]);
  EXPECT_TRUE(seen[1]);
  EXPECT_FALSE(seen[2]);
}

}  // namespace
}  // namespace surefoot::simulation::test
