// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What an estimate says of its scan: the motion within it, its stamp, its velocity.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/every_method.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

const Pose kEstimateStart{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

class OdometryEstimate : public EveryMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, OdometryEstimate, each_method(), method_name);

TEST_P(OdometryEstimate, PoseAtAnyInstantPutsPointsOntoTheScene) {
  // T(t) p_raw is the deskewed point in the map: the same trajectory deskewed it and is published.
  const auto motion =
      constant_velocity(kEstimateStart, (Twist() << 1.0, 0.0, 0.0, 0.0, 0.0, 0.3).finished());
  Odometry odometry(config());
  for (const Scan& scan : take_scans(furnished_hall(), motion, 10)) {
    const Estimate estimate = odometry.add_scan(scan);
    const auto& deskewed = odometry.deskewed_scan().points;
    const auto min_range = static_cast<float>(odometry.config().preprocess.min_range);
    std::size_t next = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (scan.points[i].norm() < min_range) continue;
      ASSERT_LT(next, deskewed.size());
      const Pose T = estimate.pose_at(scan.stamp_ns + scan.times_ns[i]);
      const Eigen::Vector3d raw = T * scan.points[i].cast<double>();
      const Eigen::Vector3d in_map = estimate.T_world_lidar * deskewed[next++].cast<double>();
      ASSERT_LT((raw - in_map).norm(), 2e-5);  // floats at up to 30 m
    }
    EXPECT_EQ(next, deskewed.size());
  }
}

TEST_P(OdometryEstimate, StampIsMidScanAndTwistIsTheVelocity) {
  const Twist velocity = (Twist() << 1.0, 0.0, 0.0, 0.0, 0.0, 0.2).finished();
  const auto scans = take_scans(furnished_hall(), constant_velocity(kEstimateStart, velocity), 15);
  Odometry odometry(config());
  for (const Scan& scan : scans) {
    const Estimate estimate = odometry.add_scan(scan);
    const std::int64_t last = *std::max_element(scan.times_ns.begin(), scan.times_ns.end());
    EXPECT_EQ(estimate.stamp_ns, scan.stamp_ns + last / 2);
    const Pose mid = estimate.pose_at(estimate.stamp_ns);
    EXPECT_LT((mid.matrix() - estimate.T_world_lidar.matrix()).norm(), 1e-6);
    if (&scan != &scans.back()) continue;
    // A step's error of some 18 mm over 0.1 s; measured: 0.18.
    EXPECT_LT((estimate.twist - velocity).head<3>().norm(), 0.3);
    EXPECT_LT((estimate.twist - velocity).tail<3>().norm(),
              0.15);  // measured: 0.104, the paper's below 0.05
  }
}

}  // namespace
}  // namespace surefoot
