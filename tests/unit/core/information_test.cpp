// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/information.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

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
Estimate on_a_floor(double heading) {
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
  const Pose T_map_lidar{from_roll_pitch_yaw({0.0, 0.0, heading}), Eigen::Vector3d::Zero()};
  report_weak_directions(floor, squared_distance, T_map_lidar, Config().health, estimate);
  return estimate;
}

TEST(Information, AFloorHoldsHeightAndTiltAlone) {
  const Estimate estimate = on_a_floor(0.0);
  EXPECT_EQ(estimate.status, Status::degenerate);
  ASSERT_EQ(estimate.degenerate.size(), 3U);
  for (const DegenerateDirection& weak : estimate.degenerate) {
    EXPECT_NEAR(weak.information, 0.0, 1e-12);
    EXPECT_NEAR(weak.direction[2], 0.0, 1e-9);                    // height
    EXPECT_NEAR(weak.direction.segment<2>(3).norm(), 0.0, 1e-9);  // roll and pitch
  }
}

TEST(Information, NoTwoWeakDirectionsHaveOneName) {
  for (int degrees = 0; degrees <= 90; ++degrees) {
    std::vector<std::string> names;
    for (const DegenerateDirection& weak :
         on_a_floor(degrees * std::numbers::pi / 180.0).degenerate) {
      names.push_back(weak.name);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"forward", "lateral", "yaw"})) << degrees << " deg";
  }
  // Of three that are mixed, each has "forward" as its largest part but one.
  const double part = 1.0 / std::sqrt(3.0);
  std::vector<DegenerateDirection> mixed(3);
  mixed[0].direction << 2 * part * part, -part * part, 0, 0, 0, 2 * part * part;
  mixed[1].direction << 2 * part * part, 2 * part * part, 0, 0, 0, -part * part;
  mixed[2].direction << -part * part, 2 * part * part, 0, 0, 0, 2 * part * part;
  name_directions({}, mixed);
  EXPECT_EQ(mixed[0].name, "forward");
  EXPECT_EQ(mixed[1].name, "lateral");
  EXPECT_EQ(mixed[2].name, "yaw");
}

}  // namespace
}  // namespace surefoot
