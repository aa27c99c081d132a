// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The robot's own body in the sensor's view: it hangs on the robot, however the sensor is mounted.
#include <gtest/gtest.h>

#include <cmath>

#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

constexpr double kBodyDegree = M_PI / 180.0;

/// Whether a point of the body's frame is on the trunk or on the head.
bool on_the_robot(const Eigen::Vector3d& point) {
  const auto on_box = [&](const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    constexpr double kClose = 1e-3;  // [m]
    const double outside = (low - point).cwiseMax(point - high).maxCoeff();
    return std::abs(outside) < kClose;
  };
  return on_box({-0.35, -0.09, -0.09}, {0.35, 0.09, 0.075}) ||
         on_box({0.35, -0.05, -0.04}, {0.52, 0.05, 0.085});
}

TEST(RobotBodyTest, IsWhereTheRobotIsUnderEveryMount) {
  const Pose mounts[] = {kMount,
                         {from_roll_pitch_yaw({0.0, 30.0 * kBodyDegree, 0.0}), {-0.3, 0.0, 0.45}},
                         {from_roll_pitch_yaw({0.0, 20.0 * kBodyDegree, M_PI}), {0.4, 0.05, 0.4}}};
  const Scene scene = room();
  RayCaster rays(scene);
  ScannerOptions options;
  options.robot_body = true;
  options.footprint = false;
  for (const Pose& T_body_lidar : mounts) {
    SCOPED_TRACE(T_body_lidar.translation.transpose());
    const Motion motion = make_motion(scene, rays, gait_model("trot"), 6.0, 7, T_body_lidar);
    Scanner scanner(rays, lidar_model("vlp16"), motion, options);
    const SimulatedScan scan = scanner.scan(30);
    std::size_t seen = 0;
    std::size_t elsewhere = 0;
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      if (scan.labels[i] != kLabelRobot) continue;
      ++seen;
      const Pose T_map_body = motion.T_map_body(instant(scan, i, options));
      elsewhere += on_the_robot(T_map_body.inverse() * scan.true_points[i]) ? 0U : 1U;
    }
    EXPECT_GT(seen, 20U);
    EXPECT_EQ(elsewhere, 0U) << "of " << seen;
  }
}

}  // namespace
}  // namespace surefoot::simulation::test
