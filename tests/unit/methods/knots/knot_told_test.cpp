// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is told of whole runs, where that is not what the map has: poses that a gait held back.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

const Pose kToldStart{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

TEST(KnotTold, ABounceThatKeepsTimeWithTheScansIsTold) {
  // Five bounces a second, ten scans: held back, the poses are off to either side in turn.
  const auto motion = trotting(kToldStart, 0.2, 2.5);
  Odometry odometry;
  const auto scans = take_scans(furnished_hall(), motion, 70);
  double squares = 0.0;
  Pose before;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Estimate estimate = odometry.add_scan(scans[i]);
    const Pose truth = motion(1e-9 * static_cast<double>(estimate.stamp_ns));
    const Pose error = estimate.T_world_lidar * truth.inverse();
    if (i >= 50) squares += (error.translation - before.translation).squaredNorm();
    before = error;
  }
  const double from_scan_to_scan = std::sqrt(squares / 20.0);
  std::printf("from scan to scan: %.4f m\n", from_scan_to_scan);
  EXPECT_LT(from_scan_to_scan, 0.022);  // measured: 0.0188, where the map has them 0.0249
}

TEST(KnotTold, WhoStandsIsToldWhereHeIsHeld) {
  // Noise differs from scan to scan as a gait does.
  Odometry odometry;
  const auto estimates =
      add_scans(odometry, take_scans(furnished_hall(), standing(kToldStart), 60));
  double squares = 0.0;
  for (std::size_t i = 31; i < estimates.size(); ++i) {
    const double turn = angle_between_deg(estimates[i].T_world_lidar.rotation,
                                          estimates[i - 1].T_world_lidar.rotation);
    squares += turn * turn;
  }
  const double jitter = std::sqrt(squares / 29.0);
  std::printf("from scan to scan: %.4f deg\n", jitter);
  EXPECT_LT(jitter, 0.029);  // measured: 0.0271, let go of 0.0303
}

TEST(KnotTold, WhatIsToldIsOneMotion) {
  // Pose, motion within the scan, deskewed points and the last pose, once poses are let go of.
  const auto scans = take_scans(furnished_hall(), trotting(kToldStart, 0.2, 2.5), 50);
  Odometry odometry;
  const auto estimates = add_scans(odometry, scans);
  const Estimate& last = estimates.back();
  const Scan& scan = scans.back();
  const std::vector<Eigen::Vector3f> deskewed = odometry.deskewed_scan().points;
  ASSERT_EQ(deskewed.size(), scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); i += 97) {
    const Pose T = last.pose_at(scan.stamp_ns + scan.times_ns[i]);
    const Eigen::Vector3d raw = T * scan.points[i].cast<double>();
    ASSERT_LT((raw - last.T_world_lidar * deskewed[i].cast<double>()).norm(), 2e-5);  // floats
  }
  Scan empty;
  empty.stamp_ns = scan.stamp_ns + 100'000'000;
  const Pose again = odometry.add_scan(empty).T_world_lidar;
  EXPECT_LT((again.matrix() - last.T_world_lidar.matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace surefoot
