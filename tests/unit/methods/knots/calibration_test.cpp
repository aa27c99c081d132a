// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/calibration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

const Twist kTrotting = (Twist() << 0.2, 0.2, 0.2, 0.5, 0.5, 0.2).finished();

Twist walking(double x, double y) { return (Twist() << x, y, 0.3, 0.1, 0.2, 0.3).finished(); }

Matrix6 random_covariance(Random& random) {
  Matrix6 root;
  for (int i = 0; i < 6; ++i) root.col(i) = random.twist(1.0, 1.0);
  return root * root.transpose() + 0.1 * Matrix6::Identity();
}

TEST(Calibration, ErrorsAreLargerAlongTheWayAndInRollAboutIt) {
  const Matrix6 c = calibrated(Matrix6::Identity(), walking(50.0, 0.0), kTrotting);
  const Twist deviations = c.diagonal().cwiseSqrt();
  const Twist expected = (Twist() << 1.2, 0.75, 0.9, 1.5, 1.1, 0.8).finished();
  EXPECT_LT((deviations - expected).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Calibration, WhoStandsHasNoWay) {
  const Matrix6 c = calibrated(Matrix6::Identity(), Twist::Zero(), kTrotting);
  EXPECT_DOUBLE_EQ(c(0, 0), c(1, 1));
  EXPECT_DOUBLE_EQ(c(3, 3), c(4, 4));
  EXPECT_NEAR(c(0, 0), 1.44, 1e-12);
}

TEST(Calibration, TheMapsHeadingChangesNothing) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Matrix6 covariance = random_covariance(random);
    const Twist velocity = walking(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
    Matrix6 turn = Matrix6::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() =
        so3_exp({0.0, 0.0, random.uniform(-3.0, 3.0)}).toRotationMatrix();
    const Matrix6 here = calibrated(covariance, velocity, kTrotting);
    const Matrix6 there =
        calibrated(turn * covariance * turn.transpose(), turn * velocity, kTrotting);
    EXPECT_LT((there - turn * here * turn.transpose()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Calibration, ACovarianceStaysOne) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Twist fluctuation = random.twist(1.0, 3.0).cwiseAbs();
    const Matrix6 c = calibrated(random_covariance(random), random.twist(5.0, 1.0), fluctuation);
    EXPECT_LT((c - c.transpose()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(c).eigenvalues().minCoeff(), 0.0);
  }
}

TEST(Calibration, ASmoothRideIsKnownBetter) {
  const auto variance = [](double tilt) {
    const Twist fluctuation = (Twist() << 0.2, 0.2, 0.2, tilt, tilt, 0.1).finished();
    return calibrated(Matrix6::Identity(), walking(1.0, 0.0), fluctuation)(0, 0);
  };
  EXPECT_NEAR(variance(1.0) / variance(0.5), std::pow(2.0, 0.25), 1e-12);
  EXPECT_LT(variance(0.1), variance(0.5));
  EXPECT_EQ(variance(0.0), variance(0.1));  // but nothing is known without end
}

}  // namespace
}  // namespace surefoot
