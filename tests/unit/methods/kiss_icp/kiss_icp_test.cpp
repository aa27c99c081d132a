// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/kiss_icp/kiss_icp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/so3.hpp"
#include "methods/shared/adaptive_threshold.hpp"
#include "methods/shared/constant_velocity.hpp"
#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

TEST(KissIcp, TheKernelIsGemanMcClure) {
  for (const double kernel : {0.1, 0.7, 2.0}) {
    EXPECT_EQ(geman_mcclure_weight(0.0, kernel), 1.0);
    for (const double r2 : {0.01, 0.5, 9.0}) {
      const double expected = kernel * kernel / ((kernel + r2) * (kernel + r2));
      EXPECT_NEAR(geman_mcclure_weight(r2, kernel), expected, 1e-15);
    }
  }
}

TEST(KissIcp, PointToPointEquationsAreThoseOfTheJacobian) {
  test::Random random(1);
  PointToPointSum sum;
  Matrix6 H = Matrix6::Zero();
  Twist g = Twist::Zero();
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d s = random.vector(20.0);
    const Eigen::Vector3d q = s + random.vector(0.5);
    const double w = random.uniform(0.1, 1.0);
    sum.add(s, q, w);
    Eigen::Matrix<double, 3, 6> J;
    J << Eigen::Matrix3d::Identity(), -hat(s);
    H += w * J.transpose() * J;
    g += w * J.transpose() * (s - q);
  }
  const NormalEquations<6> equations = sum.equations();
  EXPECT_LT((equations.H - H).norm(), 1e-9 * H.norm());
  EXPECT_LT((equations.g - g).norm(), 1e-9 * g.norm());
  EXPECT_EQ(equations.count, 50);
}

TEST(KissIcp, TheJacobianIsTheDerivative) {
  const Eigen::Vector3d s(3.0, -2.0, 0.5), q(2.9, -2.2, 0.4);
  PointToPointSum sum;
  sum.add(s, q, 1.0);
  for (int i = 0; i < 6; ++i) {  // g is the gradient of half the squared residual
    const double step = 1e-6;
    const auto half_square = [&](double x) {
      return 0.5 * (se3_exp(x * Twist::Unit(i)) * s - q).squaredNorm();
    };
    EXPECT_NEAR(sum.equations().g[i], (half_square(step) - half_square(-step)) / (2.0 * step),
                1e-8);
  }
}

TEST(KissIcp, TheThresholdIsTheRmsOfLargeDeviations) {
  AdaptiveThreshold threshold(2.0, 0.1, 100.0);
  EXPECT_EQ(threshold.threshold(), 2.0);
  threshold.add({Eigen::Quaterniond::Identity(), {0.05, 0.0, 0.0}});  // too small to count
  EXPECT_EQ(threshold.threshold(), 2.0);
  threshold.add({Eigen::Quaterniond::Identity(), {0.3, 0.4, 0.0}});
  EXPECT_NEAR(threshold.threshold(), std::sqrt((4.0 + 0.25) / 2.0), 1e-12);
  threshold.add({so3_exp({0.0, 0.0, 0.01}), {0.3, 0.4, 0.0}});
  // The chord that a point at 100 m moves along.
  const double chord = (so3_exp({0.0, 0.0, 0.01}) * Eigen::Vector3d(100.0, 0.0, 0.0) -
                        Eigen::Vector3d(100.0, 0.0, 0.0))
                           .norm();
  const double error = 0.5 + chord;
  EXPECT_NEAR(threshold.threshold(), std::sqrt((4.0 + 0.25 + error * error) / 3.0), 1e-9);
}

TEST(KissIcp, DeskewingGoesToTheAskedInstant) {
  PreparedScan scan;
  scan.end_ns = 100'000'000;
  const Twist motion = (Twist() << 0.2, -0.1, 0.05, 0.02, -0.03, 0.1).finished();
  const Eigen::Vector3d landmark(5.0, 3.0, -1.0);  // in the frame at the scan's end
  for (const float tau : {0.0F, 0.25F, 1.0F}) {
    const Pose T_end_now = se3_exp((static_cast<double>(tau) - 1.0) * motion);
    scan.points.push_back((T_end_now.inverse() * landmark).cast<float>());
    scan.taus.push_back(tau);
  }
  for (const auto& point : deskew_to(1.0, scan, motion, Workers(1))) {
    EXPECT_LT((point - landmark).norm(), 1e-5);  // floats
  }
  const Pose T_map_end{so3_exp({0.1, 0.2, 0.3}), {1.0, 2.0, 3.0}};
  const ScanTrajectory trajectory = constant_velocity_through(T_map_end, 1.0, motion, scan);
  EXPECT_LT((trajectory.at(1.0).translation - T_map_end.translation).norm(), 1e-12);
  const Pose mid = T_map_end * se3_exp(-0.5 * motion);
  EXPECT_LT((trajectory.at(0.5).translation - mid.translation).norm(), 1e-12);
  EXPECT_LT(so3_log(trajectory.at(0.5).rotation.conjugate() * mid.rotation).norm(), 1e-12);
}

/// Points on the walls of a room.
std::vector<Eigen::Vector3d> room_points() {
  std::vector<Eigen::Vector3d> points;
  for (double a = -4.9; a < 5.0; a += 0.35) {
    for (double b = -1.4; b < 1.5; b += 0.35) {
      points.insert(points.end(), {{a, 5.0, b}, {a, -5.0, b}, {5.0, a, b}, {-5.0, a, b}});
    }
    for (double b = -4.9; b < 5.0; b += 0.7) points.push_back({a, b, -1.5});
  }
  return points;
}

TEST(KissIcp, RegistrationFindsAKnownMotion) {
  VoxelMap map({1.0, 20, 0.0, 100.0});
  for (const auto& point : room_points()) map.insert(point);
  const Pose truth{so3_exp({0.01, -0.02, 0.03}), {0.1, -0.08, 0.05}};
  const auto seen = transformed(truth.inverse(), room_points());
  const Alignment found = align_points_to_map(
      seen, map, Pose{}, 1.0, test::default_parameters<KissIcpParameters>(), Workers(1));
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.equations.count, static_cast<int>(seen.size()));
  EXPECT_LT((found.T_map_lidar.translation - truth.translation).norm(), 1e-3);
  EXPECT_LT(so3_log(found.T_map_lidar.rotation.conjugate() * truth.rotation).norm(), 1e-3);
}

TEST(KissIcp, WithoutMatchesThePredictionStands) {
  VoxelMap map({1.0, 20, 0.0, 100.0});
  map.insert({50.0, 50.0, 50.0});
  const Pose guess{so3_exp({0.1, 0.0, 0.0}), {1.0, 2.0, 3.0}};
  const Alignment found = align_points_to_map(
      room_points(), map, guess, 1.0, test::default_parameters<KissIcpParameters>(), Workers(1));
  EXPECT_EQ(found.equations.count, 0);
  EXPECT_TRUE(found.finite);
  EXPECT_LT((found.T_map_lidar.translation - guess.translation).norm(), 1e-12);
}

}  // namespace
}  // namespace surefoot
