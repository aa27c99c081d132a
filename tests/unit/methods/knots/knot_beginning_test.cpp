// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings that begin in motion: how the first two scans moved, and that a map which holds a
// direction badly is not begun again and again.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

const Pose kBegin{Eigen::Quaterniond::Identity(), {0.0, 0.5, 0.45}};

std::vector<Estimate> run(const std::vector<Scan>& scans) {
  Odometry odometry{Config{}};
  return add_scans(odometry, scans);
}

/// Grass without end, and a fence along the way: how far it walks along that, nothing tells.
Scene fenced_field() {
  Scene scene;
  scene.add(box_between({-200.0, -200.0, -1.0}, {200.0, 200.0, 0.0}));
  scene.add(box_between({-150.0, 9.0, 0.0}, {150.0, 9.1, 1.2}));
  return scene;
}

/// A road between houses of unequal depth.
Scene road() {
  Scene scene;
  scene.add(box_between({-200.0, -200.0, -1.0}, {200.0, 200.0, 0.0}));
  for (int i = -6; i < 14; ++i) {
    const double x = 9.0 * i, depth = 1.5 * ((i * i + 6) % 4);
    scene.add(box_between({x, 7.0 + depth, 0.0}, {x + 6.0, 20.0, 5.0}));
    scene.add(box_between({x + 3.0, -20.0, 0.0}, {x + 8.0, -6.0 - depth, 6.0}));
  }
  return scene;
}

TEST(KnotBeginning, AMapThatHoldsADirectionBadlyIsNotBegunAgain) {
  const MotionFunction motion = trotting(kBegin, 1.2, 2.0);
  const auto estimates = run(take_scans(fenced_field(), motion, 12));
  EXPECT_EQ(estimates.back().segment, 0) << statuses(estimates);
  EXPECT_FALSE(estimates[1].degenerate.empty());
  for (const Estimate& e : estimates) EXPECT_NE(e.status, Status::ok) << statuses(estimates);
}

TEST(KnotBeginning, ASwingOfTheFirstScanIsNotMapped) {
  for (const double hertz : {2.0, 2.5}) {
    const MotionFunction motion = trotting(kBegin, 0.8, hertz);
    const Error error = error_against(run(take_scans(furnished_hall(), motion, 10)), motion);
    // Measured: 0.006, 0.011 m and 0.13, 0.15 deg; with the first scan's motion taken from the
    // second's 0.019 m and 0.29, 0.33 deg.
    EXPECT_LT(error.translation, 0.014) << hertz;
    EXPECT_LT(error.rotation_deg, 0.22) << hertz;
  }
}

/// RMS over scans from the 20th on of how far each attitude within the scan is off, relative to the
/// one at its middle [deg].
double attitude_within(const std::vector<Estimate>& estimates, const MotionFunction& motion) {
  double squares = 0.0;
  int count = 0;
  for (std::size_t n = 20; n < estimates.size(); ++n) {
    const ScanTrajectory& scan = estimates[n].trajectory;
    for (const double tau : {0.0, 0.25, 0.75, 1.0}) {
      const auto seconds_at = [&](double at) {
        return 1e-9 * (static_cast<double>(scan.start_ns()) +
                       at * static_cast<double>(scan.end_ns() - scan.start_ns()));
      };
      const Pose found = scan.at(0.5).inverse() * scan.at(tau);
      const Pose real = motion(seconds_at(0.5)).inverse() * motion(seconds_at(tau));
      squares += so3_log(real.rotation.conjugate() * found.rotation).squaredNorm();
      ++count;
    }
  }
  return std::sqrt(squares / count) * 180.0 / std::numbers::pi;
}

// Bent by a first scan that swung, a map bends what it is given alike, and goes on to.
TEST(KnotBeginning, AMapThatASwingBentIsStraightened) {
  for (const double phase : {0.13, 0.2}) {
    const MotionFunction whole = trotting(kBegin, 1.2, 2.3);
    const MotionFunction motion = [&](double t) { return whole(phase + t); };
    const auto estimates = run(take_scans(furnished_hall(), motion, 40));
    // Measured: 0.40 and 0.36; as registered 1.12 and 0.89.
    EXPECT_LT(attitude_within(estimates, motion), 0.48) << phase;
  }
}

TEST(KnotBeginning, ATurnOfTheFirstScanIsNotMapped) {
  for (const double rate : {-1.6, 0.8, 1.6}) {
    const MotionFunction motion =
        constant_velocity(kBegin, (Twist() << 0, 0, 0, 0, 0, rate).finished());
    const Error error = error_against(run(take_scans(furnished_hall(), motion, 10)), motion);
    // Measured: at most 0.009 m, and 0.44, 0.15 and 0.39 deg; from rest alone 2.03, 0.52 and 0.83.
    EXPECT_LT(error.translation, 0.014) << rate;
    EXPECT_LT(error.rotation_deg, 0.37 * std::abs(rate)) << rate;
  }
}

TEST(KnotBeginning, ACarsSpeedIsFound) {
  for (const double speed : {5.0, 9.0, 14.0}) {
    const MotionFunction motion =
        constant_velocity(kBegin, (Twist() << speed, 0, 0, 0, 0, 0).finished());
    const auto estimates = run(take_scans(road(), motion, 12));
    // Measured: 0.001, 0.004 and 0.012 m.
    EXPECT_LT(error_against(estimates, motion).translation, 0.03)
        << speed << ": " << statuses(estimates);
  }
}

/// Taken standing, the n-th c n^2 / 2 along the road, as keyframes are: no times tell how fast.
std::vector<Scan> keyframes(double c, int count) {
  std::vector<Scan> scans;
  for (int n = 0; n < count; ++n) {
    const Pose at{kBegin.rotation, kBegin.translation + Eigen::Vector3d(0.5 * c * n * n, 0.0, 0.0)};
    scans.push_back(take_scans(road(), standing(at), 1, {}, n).front());
    scans.back().times_ns.clear();
  }
  return scans;
}

TEST(KnotBeginning, WhoSpeedsUpIsNotHeldBackByAFadingMean) {
  constexpr double kMore = 0.35;  // [m] at every scan
  constexpr int kScans = 20;
  const auto estimates = run(keyframes(kMore, kScans));
  const double way = 0.5 * kMore * (kScans - 1) * (kScans - 1);
  // Measured: 0.19 m; where the mean velocity only fades 0.39.
  EXPECT_NEAR(estimates.back().T_world_lidar.translation.x(), way, 0.28) << statuses(estimates);
}

}  // namespace
}  // namespace surefoot
