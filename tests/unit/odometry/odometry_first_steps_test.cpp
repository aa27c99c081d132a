// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Runs that begin while the sensor moves: the first step has no last motion to predict from. A
// smooth straight walk on a level floor is the hard case: rings on the floor and walls along the
// way look the same from everywhere, and what sways in a trot would tell.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <string>

#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kScans = 40;
const Pose kStart{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

MotionFunction straight_walk(double speed) {
  return constant_velocity(kStart, (Twist() << speed, 0, 0, 0, 0, 0).finished());
}

struct Walk {
  Error error;
  double first_step = 0.0;  ///< [m]
  bool trusted = true;
};

Walk walk(const std::string& name, const Scene& scene, const MotionFunction& motion,
          int scans = kScans, const Config& config = {}) {
  Odometry odometry(config);
  const auto estimates = add_scans(odometry, take_scans(scene, motion, scans));
  Walk result{error_against(estimates, motion)};
  result.first_step =
      (estimates[1].T_map_lidar.translation - estimates[0].T_map_lidar.translation).norm();
  for (const Estimate& estimate : estimates) result.trusted &= estimate.trusted();
  EXPECT_TRUE(result.trusted) << name << ": " << statuses(estimates);
  std::printf("%-32s first step %.4f m, error %.4f m (z %.4f), %.3f deg\n", name.c_str(),
              result.first_step, result.error.translation, result.error.vertical,
              result.error.rotation_deg);
  return result;
}

MotionFunction pitched(const MotionFunction& motion) {
  return mounted(motion, {from_roll_pitch_yaw({0.0, 15.0 * kDegree, 0.0}), {0.0, 0.0, 0.0}});
}

TEST(OdometryFirstSteps, AStraightWalkThroughAFurnishedHallIsFollowed) {
  for (const double speed : {1.0, 0.5}) {
    const Walk way =
        walk("furnished hall " + std::to_string(speed), furnished_hall(), straight_walk(speed));
    // Measured: 0.045 .. 0.051 and 0.074 .. 0.076. The first two or three steps come out at half
    // their length.
    EXPECT_LT(way.error.translation, 0.14) << speed << " m/s";
  }
}

TEST(OdometryFirstSteps, AStraightWalkWithAPitchedMountIsFollowed) {
  const Walk way = walk("pitched, furnished hall", furnished_hall(), pitched(straight_walk(1.0)));
  EXPECT_LT(way.error.translation, 0.6);  // measured: 0.37 of 4 m
}

// Known shortcomings, run with --gtest_also_run_disabled_tests: on a bare floor the horizontal
// stage's point-to-point residuals hold a smoothly walking sensor back, whatever the prediction.
TEST(OdometryFirstSteps, DISABLED_AStraightWalkThroughABareHallIsFollowed) {
  for (const double speed : {1.0, 0.5}) {
    const Walk way = walk("bare hall " + std::to_string(speed), bare_hall(), straight_walk(speed));
    EXPECT_LT(way.error.translation, 0.2) << speed << " m/s";  // measured: 0.82 and 0.87 .. 1.87
  }
}

TEST(OdometryFirstSteps, DISABLED_ASlowOrBareWalkWithAPitchedMountIsFollowed) {
  const Scene bare = bare_hall(), furnished = furnished_hall();
  const auto fast = pitched(straight_walk(1.0)), slow = pitched(straight_walk(0.5));
  // Measured: 1.62, 3.85 and 1.91 m, of ways of 2, 4 and 2 m.
  EXPECT_LT(walk("pitched, furnished, 0.5 m/s", furnished, slow).error.translation, 0.2);
  EXPECT_LT(walk("pitched, bare, 1 m/s", bare, fast).error.translation, 0.2);
  EXPECT_LT(walk("pitched, bare, 0.5 m/s", bare, slow).error.translation, 0.2);
}

TEST(OdometryFirstSteps, PointToPlaneFollowsEachOfTheseWalks) {
  // The scans do tell the motion: what the first motion is taken from never loses it.
  Config config = method_config("paper-coupled");
  config.registration.coupled_residual = CoupledResidual::point_to_plane;
  for (const Scene& scene : {bare_hall(), furnished_hall()}) {
    for (const double speed : {1.0, 0.5}) {
      for (const auto& motion : {straight_walk(speed), pitched(straight_walk(speed))}) {
        const Walk way = walk("point to plane", scene, motion, kScans, config);
        EXPECT_NEAR(way.first_step, 0.1 * speed, 0.02);  // measured: within 0.013
        EXPECT_LT(way.error.translation, 0.05);          // measured: 0.013 .. 0.027
      }
    }
  }
}

TEST(OdometryFirstSteps, EveryDirectionAndTurnIsFollowed) {
  const Twist velocities[] = {
      (Twist() << -1.0, 0, 0, 0, 0, 0).finished(), (Twist() << 0, 0.8, 0, 0, 0, 0).finished(),
      (Twist() << 0.7, 0.3, 0, 0, 0, 0.6).finished(), (Twist() << 0, 0, 0, 0, 0, 1.0).finished()};
  for (const Twist& velocity : velocities) {
    const auto motion = constant_velocity({kStart.rotation, {0.0, 0.5, 0.45}}, velocity);
    const std::string name = std::to_string(velocity[0]) + ' ' + std::to_string(velocity[1]) + ' ' +
                             std::to_string(velocity[5]);
    const Walk way = walk(name, furnished_hall(), motion, 12);
    EXPECT_LT(way.error.translation, 0.19) << name;  // measured: 0.020 .. 0.110
    EXPECT_LT(way.error.rotation_deg, 3.0) << name;  // measured: 0.2 .. 1.75
  }
}

TEST(OdometryFirstSteps, AStandingSensorIsNotSetInMotion) {
  const Walk way = walk("standing", bare_hall(), standing(kStart), 5);
  EXPECT_LT(way.first_step, 0.005);  // measured: 0.0013 .. 0.0025
}

}  // namespace
}  // namespace surefoot
