// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Deskewing, eqs. (10)-(12), against Eigen's matrix functions and static scenes seen by a moving
// sensor.
#include "core/deskew.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "core/segment_motion.hpp"
#include "support/matrix_exponential.hpp"
#include "support/random.hpp"
#include "support/static_scene.hpp"

namespace surefoot {
namespace {

using test::kEnd;
using test::kFloatRounding;
using test::kStart;
using test::largest_miss;
using test::measure;
using test::Random;
using test::random_scene;

/// A motion of K segments, each another way.
ScanTrajectory random_far_trajectory(Random& random, int K) {
  std::vector<Pose> boundaries{random.pose(100.0, 3.0)};
  for (int k = 0; k < K; ++k) {
    boundaries.push_back(boundaries.back() * se3_exp(random.twist(0.5 / K, 0.3 / K)));
  }
  return ScanTrajectory(std::move(boundaries), kStart, kEnd);
}

TEST(Deskew, ConstantVelocityRestoresAStaticSceneUnderOneTwist) {
  Random random(4);
  const Pose T_start = random.pose(5.0, 1.0);
  const Twist twist = random.twist(0.3, 0.15);
  const auto motion = [&](double tau) { return T_start * se3_exp(tau * twist); };
  const auto scene = random_scene(random, T_start, 2000);
  const ScanTrajectory trajectory({T_start, T_start * se3_exp(twist)}, kStart, kEnd);
  const auto deskewed = deskew(measure(scene, motion), trajectory, Workers(1));
  EXPECT_LT(largest_miss(deskewed, motion(0.5), scene), kFloatRounding);
}

TEST(Deskew, EveryPointEqualsBruteForcePoseAlgebra) {
  Random random(7);
  for (const int K : {1, 3, 4, 16}) {
    const ScanTrajectory trajectory = random_far_trajectory(random, K);
    PreparedScan scan;
    for (int i = 0; i < 3000; ++i) {
      scan.points.emplace_back(random.vector(40.0).cast<float>());
      const double tau = i < 2 * K + 1 ? 0.5 * i / K : random.uniform(0.0, 1.0);
      scan.taus.push_back(static_cast<float>(tau));
    }
    const auto deskewed = deskew(scan, trajectory, Workers(1));
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double tau = static_cast<double>(scan.taus[i]);
      // The last k with tau_k <= tau, by search; the paper's interval for tau = 1 is empty, so
      // that its last segment takes it.
      int k = K - 1;
      while (static_cast<double>(k) / K > tau) --k;
      const double u = (tau - static_cast<double>(k) / K) * K;
      const auto at = [&](int j) { return trajectory.boundary(static_cast<std::size_t>(j)); };
      const Twist xi = test::matrix_logarithm((at(k).inverse() * at(k + 1)).matrix());
      const Eigen::Matrix4d T_tau = at(k).matrix() * test::matrix_exponential(u * xi);
      const Eigen::Vector4d point = scan.points[i].cast<double>().homogeneous();
      const Eigen::Matrix4d T_mid = trajectory.at(0.5).matrix();
      const Eigen::Vector4d expected = T_mid.inverse() * T_tau * point;
      ASSERT_LT((deskewed[i].cast<double>() - expected.head<3>()).norm(), kFloatRounding)
          << "K " << K << " tau " << tau;
    }
  }
}

// The series for small angles and the library's sine and cosine, and where they meet.
TEST(SegmentMotion, IsTheExponentialAtEveryAngle) {
  Random random(5);
  for (const double angle : {0.0, 1e-8, 0.01, 0.2499, 0.2501, 3.0}) {
    const Pose start = se3_exp(random.twist(5.0, 1.0));
    Twist twist;
    twist << random.vector(1.0), angle * random.unit_vector();
    const SegmentMotion motion(start, twist);
    const Eigen::Vector3d point = random.vector(100.0);
    for (const double u : {0.3, 1.0}) {
      EXPECT_LT((motion(u, point) - start * se3_exp(u * twist) * point).norm(), 1e-10) << angle;
    }
  }
}

TEST(Deskew, ScansWithoutTimesKeepEveryBit) {
  Random random(8);
  PreparedScan scan;
  for (int i = 0; i < 100; ++i) scan.points.emplace_back(random.vector(40.0).cast<float>());
  EXPECT_EQ(deskew(scan, random_far_trajectory(random, 4), Workers(1)), scan.points);
}

TEST(Deskew, ThreadsDoNotChangeABit) {
  Random random(9);
  const ScanTrajectory trajectory = random_far_trajectory(random, 4);
  PreparedScan scan;
  for (int i = 0; i < 5000; ++i) {
    scan.points.emplace_back(random.vector(40.0).cast<float>());
    scan.taus.push_back(static_cast<float>(i) / 4999.0F);
  }
  const auto alone = deskew(scan, trajectory, Workers(1));
  for (const int threads : {2, 3, 8}) {
    EXPECT_EQ(deskew(scan, trajectory, Workers(threads)), alone);
  }
}

}  // namespace
}  // namespace surefoot
