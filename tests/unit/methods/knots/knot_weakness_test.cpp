// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a scene does not hold, it says. benchmarks/reliability does more of it, to simulated scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "fault_walk.hpp"
#include "geometry/so3.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

// Its rings go with the sensor: of the way along it they tell nothing, and nothing says so but
// that.
TEST(KnotWeakness, ABareFloorHoldsNoPlaceAndItSaysSo) {
  std::vector<Scan> scans = walk_scans();
  for (int i = kEvent; i < kFaultScans; ++i) make_floor(scans[static_cast<std::size_t>(i)]);
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  for (int i = kEvent; i < kFaultScans; ++i) {
    const Estimate& estimate = all[static_cast<std::size_t>(i)];
    EXPECT_EQ(estimate.status, Status::degenerate) << i << ' ' << statuses(all);
    const double error = end_error(all, estimate, walk());
    EXPECT_LT(error, 3.0 * std::sqrt(estimate.covariance(0, 0))) << i;
    if (error > 0.4) {
      EXPECT_GT(estimate.wrong_probability, 0.5) << i;
    }
  }
}

/// Firings of a spinning LiDAR of 16 beams, so far apart [deg].
Scanner scanner_of(double apart) {
  return {.columns = static_cast<int>(std::lround(360.0 / apart))};
}

/// Every estimate but the first says that the way along x is not held, and is not surer of it than
/// it is right.
void expect_open_ahead(const std::vector<Estimate>& all, const MotionFunction& motion) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_EQ(all[i].status, Status::degenerate) << i << ' ' << statuses(all);
    EXPECT_LT(end_error(all, all[i], motion), 3.0 * std::sqrt(all[i].covariance(0, 0))) << i;
  }
}

// What a voxel cuts off a wall, or a firing shows of it, is upright and narrow: no pole that would
// hold who walks along. Askew, so that the voxels cut corners off the walls.
TEST(KnotWeakness, ATunnelHoldsNoPlaceAlongItAndItSaysSo) {
  for (const double yaw : {0.0, 0.4, 0.785}) {
    Scene tunnel;
    tunnel.add(box_between({-400.0, -2.0, 0.0}, {400.0, 2.0, 3.0}));
    const Pose turn{so3_exp({0.0, 0.0, yaw}), Eigen::Vector3d::Zero()};
    const Pose start{turn.rotation, turn * Eigen::Vector3d(0.0, 0.3, 0.5)};
    const MotionFunction motion = [=](double t) {  // stands for a second, and walks
      const double x = 0.8 * std::max(t - 1.0, 0.0);
      return start * Pose{Eigen::Quaterniond::Identity(), {x, 0.0, 0.0}};
    };
    Odometry odometry;
    const auto all =
        add_scans(odometry, take_scans(tunnel.moved(turn), motion, 30, scanner_of(0.4)));
    expect_open_ahead(all, motion);
  }
}

/// A floor and one wall, along x.
Scene yard_with_a_wall() {
  Scene yard;
  yard.add(box_between({-400.0, -200.0, -1.0}, {400.0, 200.0, 0.0}));
  yard.add(box_between({-400.0, 3.0, 0.0}, {400.0, 4.0, 4.0}));
  return yard;
}

TEST(KnotWeakness, OneWallOnALevelFloorHoldsNoPlaceAlongIt) {
  const Pose start{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5}};
  const MotionFunction motion =
      constant_velocity(start, (Twist() << 0.5, 0, 0, 0, 0, 0).finished());
  Odometry odometry;
  expect_open_ahead(
      add_scans(odometry, take_scans(yard_with_a_wall(), motion, 30, scanner_of(0.2))), motion);
}

TEST(KnotWeakness, ADirectionThatIsNotHeldIsToldInTheWorldsAxes) {
  const auto scans = take_scans(yard_with_a_wall(), standing(kFaultStart), 3, scanner_of(0.4));
  for (const double yaw : {0.0, 0.5, 2.0}) {
    Odometry odometry({}, 1, {so3_exp({0.0, 0.0, yaw}), {7.0, 8.0, 9.0}});
    const Estimate last = add_scans(odometry, scans).back();
    ASSERT_EQ(last.degenerate.size(), 1U) << last.message;
    const Twist& open = last.degenerate[0].direction;
    const Eigen::Vector3d along(std::cos(yaw), std::sin(yaw), 0.0);
    EXPECT_GT(std::abs(open.head<3>().dot(along)), 0.99 * open.norm()) << open.transpose();
  }
}

// What was never held may have moved since the map began, not since 1970.
TEST(KnotWeakness, WhatIsNotHeldFromTheFirstScanOnDriftsFromThere) {
  Scanner scanner = scanner_of(0.4);
  const auto last = [&] {
    Odometry odometry;
    return add_scans(odometry, take_scans(yard_with_a_wall(), standing(kFaultStart), 3, scanner))
        .back();
  };
  const Estimate from_zero = last();
  scanner.epoch_ns = 1'700'000'000'000'000'000;
  const Estimate today = last();
  EXPECT_EQ(today.status, Status::degenerate);
  EXPECT_NEAR(today.covariance(0, 0), from_zero.covariance(0, 0), 1e-9);
  EXPECT_LT(std::sqrt(today.covariance(0, 0)), 1.0);
}

TEST(KnotWeakness, WhoSeesMoreAgainIsOkAgain) {
  std::vector<Scan> scans = walk_scans();
  for (std::size_t i = kEvent; i < kEvent + 5; ++i) make_floor(scans[i]);
  Odometry odometry;
  const auto all = add_scans(odometry, scans);
  EXPECT_EQ(all[kEvent].status, Status::degenerate) << statuses(all);
  EXPECT_LT(std::sqrt(all[kEvent].covariance(0, 0)), 0.3) << "held until a scan ago";
  EXPECT_EQ(all.back().status, Status::ok) << statuses(all);
}

}  // namespace
}  // namespace surefoot
