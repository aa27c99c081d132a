// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/information.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace surefoot {
namespace {

TEST(Information, UnregisteredCovarianceIsWhatARegistrationMayCorrect) {
  Config::Health health = Config().health;
  health.max_correction = 2.0;
  health.max_correction_deg = 90.0;
  const Matrix6 covariance = unregistered_covariance(health);
  EXPECT_DOUBLE_EQ(covariance(0, 0), 4.0);
  EXPECT_DOUBLE_EQ(covariance(5, 5), 0.25 * std::numbers::pi * std::numbers::pi);
  EXPECT_EQ(covariance(0, 5), 0.0);
}

/// A floor seen all around: point-to-plane residuals of evenly spread points on z = -1.
TEST(Information, AFloorHoldsHeightAndTiltAlone) {
  NormalEquations<6> floor;
  double squared_distance = 0.0;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180.0;
    const Eigen::Vector3d s(5.0 * std::cos(angle), 5.0 * std::sin(angle), -1.0);
    Eigen::Matrix<double, 1, 6> J;
    J << 0.0, 0.0, 1.0, s.cross(Eigen::Vector3d::UnitZ()).transpose();
    floor.add<1>(J, Eigen::Matrix<double, 1, 1>::Zero(), 2.0);
    squared_distance += 2.0 * s.squaredNorm();
  }
  Estimate estimate;
  estimate.status = Status::ok;
  report_weak_directions(floor, squared_distance, {}, Config().health, estimate);
  EXPECT_EQ(estimate.status, Status::degenerate);
  ASSERT_EQ(estimate.degenerate.size(), 3U);
  for (const DegenerateDirection& weak : estimate.degenerate) {
    EXPECT_NEAR(weak.information, 0.0, 1e-12);
    EXPECT_NEAR(weak.direction[2], 0.0, 1e-9);                    // height
    EXPECT_NEAR(weak.direction.segment<2>(3).norm(), 0.0, 1e-9);  // roll and pitch
  }
}

}  // namespace
}  // namespace surefoot
