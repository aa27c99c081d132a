// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The share of a pose's covariance that deskewing by predictions leaves, and whether the whole
// covariance is as large as the errors of a shaking sensor are.
#include "methods/paper/prediction_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/dense_algebra.hpp"
#include "support/random.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

TEST(PredictionError, NothingIsAddedBeforeAPredictionFailed) {
  PredictionError error;
  EXPECT_EQ(error.deskew_covariance().norm(), 0.0);
  const Pose pose{so3_exp({0.1, 0.2, 0.3}), {4.0, 5.0, 6.0}};
  error.add(pose, pose);
  EXPECT_LT(error.deskew_covariance().norm(), 1e-25);
}

TEST(PredictionError, LastingErrorsCountByHalfTheirSquares) {
  PredictionError error;
  const Pose T_0{so3_exp({0.1, 0.2, 0.3}), {4.0, 5.0, 6.0}};
  const Twist e = (Twist() << 0.1, -0.2, 0.05, 0.01, 0.02, -0.03).finished();
  const Pose found{so3_exp(e.tail<3>()) * T_0.rotation, T_0.translation + e.head<3>()};
  for (int i = 0; i < 200; ++i) error.add(T_0, found);
  EXPECT_LT((error.deskew_covariance() - 0.5 * e * e.transpose()).norm(), 1e-9);
}

double seconds(const Estimate& estimate) {
  return 1e-9 * static_cast<double>(estimate.stamp_ns - Scanner{}.epoch_ns);
}

/// Mean over scans of e^T C^-1 e / 6, with e the error of a scan's motion.
double normalised_error_squared(const MotionFunction& motion) {
  Odometry odometry(method_config("paper"));
  const auto estimates = add_scans(odometry, take_scans(furnished_hall(), motion, 60));
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 10; i < estimates.size(); ++i) {
    const Estimate &a = estimates[i - 1], &b = estimates[i];
    const Pose step = a.T_world_lidar.inverse() * b.T_world_lidar;
    const Pose truth = motion(seconds(a)).inverse() * motion(seconds(b));
    // Both poses' covariances, in the LiDAR's axes.
    Matrix6 C = Matrix6::Zero();
    for (const Estimate* e : {&a, &b}) {
      Matrix6 turn = Matrix6::Zero();
      turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
          e->T_world_lidar.rotation.toRotationMatrix().transpose();
      C += turn * e->covariance * turn.transpose();
    }
    const Twist error = se3_log(truth.inverse() * step);
    sum += test::normalised_square(error, C) / 6.0;
    ++count;
  }
  return sum / count;
}

TEST(PredictionError, CovarianceFitsTheErrorsOfATrot) {
  const Pose start{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};
  const double trot = normalised_error_squared(trotting(start, 0.8, 2.3));
  const double smooth = normalised_error_squared(
      constant_velocity(start, (Twist() << 0.8, 0, 0, 0, 0, 0).finished()));
  std::printf("normalised error squared: trot %.2f, smooth %.2f\n", trot, smooth);
  EXPECT_GT(trot, 0.1);
  EXPECT_LT(trot, 4.0);
  EXPECT_LT(smooth, 4.0);
}

}  // namespace
}  // namespace surefoot
