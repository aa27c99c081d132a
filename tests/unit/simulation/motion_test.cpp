// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "simulation/ground_path.hpp"
#include "simulation/random.hpp"
#include "simulation/sequence_path.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Only the harmonics: nothing random, nothing slow.
GaitModel bare(GaitModel gait) {
  gait.footfalls.clear();
  gait.stride_variation = gait.amplitude_variation = 0.0;
  gait.wander_tilt = gait.wander_position = 0.0;
  gait.stumbles_per_minute = gait.pauses_per_minute = 0.0;
  gait.speed_variation = 0.0;
  return gait;
}

std::vector<double> offsets_of(const GaitModel& gait, BodyAxis axis, double from, double to) {
  const std::vector<WalkState> states = plan_walk(gait, to, 3);
  const std::vector<PoseAngles> offsets = oscillate(gait, states, 3);
  std::vector<double> values;
  for (auto k = static_cast<std::size_t>(from / kMotionStep); k < offsets.size(); ++k) {
    values.push_back(offsets[k](axis));
  }
  return values;
}

Motion room_motion(const GaitModel& gait, double duration, std::uint64_t seed) {
  const Scene scene = room();
  const RayCaster rays(scene);
  return make_motion(scene, rays, gait, duration, seed, kMount);
}

TEST(CubicBSplineTest, ValueAndTwoDerivativesPassEveryKnotWithoutAJump) {
  const CounterRandom random(1, 1);
  CubicBSpline<6>::Controls controls(40);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    for (int axis = 0; axis < 6; ++axis) {
      controls[i](axis) = random.normal(10 * i + static_cast<std::size_t>(axis));
    }
  }
  const CubicBSpline<6> spline(controls, 0.5);
  constexpr double kEps = 1e-6;
  const auto second = [&](double at) {
    return Eigen::Matrix<double, 6, 1>(
        (spline.derivative(at + kEps) - spline.derivative(at - kEps)) / (2.0 * kEps));
  };
  for (double knot = 0.5; knot < spline.end() - 0.1; knot += 0.5) {
    EXPECT_LT((spline(knot + 1e-9) - spline(knot - 1e-9)).norm(), 1e-7);
    EXPECT_LT((spline.derivative(knot + 1e-9) - spline.derivative(knot - 1e-9)).norm(), 1e-6);
    EXPECT_LT((second(knot + 2 * kEps) - second(knot - 2 * kEps)).norm(), 2e-3);
    const PoseAngles slope = (spline(knot + kEps) - spline(knot - kEps)) / (2.0 * kEps);
    EXPECT_LT((slope - spline.derivative(knot)).norm(), 1e-6);
  }
}

TEST(CubicBSplineTest, RefusesTooFewControlsAndABadStep) {
  EXPECT_THROW(CubicBSpline<6>(CubicBSpline<6>::Controls(3), 1.0), std::invalid_argument);
  EXPECT_THROW(CubicBSpline<6>(CubicBSpline<6>::Controls(4), 0.0), std::invalid_argument);
}

TEST(MotionTest, SeveralTimesHaveThePosesOfEach) {
  const Motion motion = room_motion(gait_model("trot"), 4.0, 5);
  // Angles near the first one's, and those of times too far away for that.
  const std::vector<double> times = {0.333, 0.3331, 1.0 / 3.0, 0.334, 0.0, 2.5, 3.999};
  std::vector<Pose> poses(times.size());
  motion.T_map_lidar(times, poses);
  motion.T_map_lidar({}, {});
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Pose alone = motion.T_map_lidar(times[i]);
    // Not to the bit: sines come from those of the first, the rotation is not normalised.
    EXPECT_LT((poses[i].rotation.coeffs() - alone.rotation.coeffs()).norm(), 1e-15);
    EXPECT_LT((poses[i].translation - alone.translation).norm(), 1e-15);
  }
}

TEST(SequencePathTest, IsTheMotionWhileItsLasersFire) {
  const CounterRandom random(1, 2);
  constexpr double kLongest = 1e-4;  // [s] of a sequence: an OS1's column lasts 98 us
  double worst = 0.0;
  for (const char* name : {"trot", "stairs", "run", "handheld"}) {
    const Motion motion = room_motion(gait_model(name), 4.0, 5);
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const double begin = random.uniform(2 * i, 0.0, 3.999);
      const double share = random.uniform(2 * i + 1, 0.0, 1.03);  // the XT-16's last laser: 1.027
      const SequencePath path(motion.T_map_lidar(begin), motion.T_map_lidar(begin + kLongest / 2),
                              motion.T_map_lidar(begin + kLongest));
      const Pose there = motion.T_map_lidar(begin + share * kLongest);
      const Eigen::Matrix<double, 3, 4> difference = path.at(share) - there.matrix().topRows<3>();
      worst = std::max(worst, difference.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LT(worst, 1e-9);  // 7.5e-10, where a gait is hardest
  EXPECT_GT(worst, 1e-14);
}

TEST(GaitTest, EveryHarmonicHasTheAmplitudeThatWasAsked) {
  for (const char* name : {"trot", "walk", "stairs", "run", "handheld"}) {
    const GaitModel gait = bare(gait_model(name));
    for (int axis = 0; axis < kBodyAxes; ++axis) {
      const auto values = offsets_of(gait, static_cast<BodyAxis>(axis), 4.0, 24.0);
      for (const Harmonic& harmonic : gait.harmonics[static_cast<std::size_t>(axis)]) {
        const double seen =
            amplitude_at(values, kMotionStep, harmonic.order * gait.stride_frequency);
        EXPECT_NEAR(seen, harmonic.amplitude, 0.02 * harmonic.amplitude)
            << name << " axis " << axis << " order " << harmonic.order;
      }
    }
  }
}

TEST(GaitTest, WithAllItsVariationTheBouncePeaksAtTwiceTheStride) {
  const GaitModel gait = gait_model("trot");
  const auto values = offsets_of(gait, kBounce, 4.0, 19.0);
  double best = 0.0;
  double peak = 0.0;
  for (double frequency = 1.0; frequency < 30.0; frequency += 0.05) {
    const double amplitude = amplitude_at(values, kMotionStep, frequency);
    if (amplitude > best) {
      best = amplitude;
      peak = frequency;
    }
  }
  EXPECT_NEAR(peak, 2.0 * gait.stride_frequency, 0.4);
  EXPECT_LT(best, 1.2 * gait.harmonics[kBounce][0].amplitude);
}

TEST(GaitTest, ImpactsRingBetween12And25Hz) {
  GaitModel with = gait_model("trot");
  GaitModel without = with;
  without.footfalls.clear();
  const auto a = offsets_of(with, kPitch, 4.0, 34.0);
  const auto b = offsets_of(without, kPitch, 4.0, 34.0);
  std::vector<double> ringing(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) ringing[i] = a[i] - b[i];
  const auto power = [&](double low, double high) {
    double sum = 0.0;
    for (double f = low; f < high; f += 0.1) {
      sum += std::pow(amplitude_at(ringing, kMotionStep, f), 2);
    }
    return sum / (high - low);
  };
  EXPECT_GT(power(12.0, 25.0), 4.0 * power(1.0, 8.0));
  EXPECT_GT(power(12.0, 25.0), 4.0 * power(35.0, 60.0));
}

TEST(GaitTest, ARunFliesAndNeverFallsFasterThanGravityPulls) {
  const GaitModel gait = bare(gait_model("run"));
  const auto z = offsets_of(gait, kBounce, 4.0, 8.0);
  double lowest = 0.0;
  for (std::size_t i = 1; i + 1 < z.size(); ++i) {
    lowest = std::min(lowest, (z[i - 1] - 2.0 * z[i] + z[i + 1]) / (kMotionStep * kMotionStep));
  }
  EXPECT_LT(lowest, -8.5);   // in the air for a while
  EXPECT_GT(lowest, -13.5);  // three harmonics overshoot the parabola a little
}

TEST(GaitTest, ScaleMultipliesAmplitudesAndNothingElse) {
  const GaitModel gait = gait_model("trot");
  const GaitModel twice = scaled(gait, 2.0);
  EXPECT_DOUBLE_EQ(twice.harmonics[kRoll][0].amplitude, 2.0 * gait.harmonics[kRoll][0].amplitude);
  EXPECT_DOUBLE_EQ(twice.impact_tilt, 2.0 * gait.impact_tilt);
  EXPECT_DOUBLE_EQ(twice.stride_frequency, gait.stride_frequency);
  EXPECT_DOUBLE_EQ(twice.speed, gait.speed);
}

TEST(MotionTest, WalksAtItsSpeedStandsStillAtFirstAndPausesAndTurns) {
  const GaitModel gait = gait_model("trot");
  const std::vector<WalkState> states = plan_walk(gait, 180.0, 5);
  const auto at = [&](double time) {
    return states[static_cast<std::size_t>(time / kMotionStep) + 1];
  };
  EXPECT_EQ(at(0.9).distance, 0.0);
  EXPECT_NEAR((at(12.0).distance - at(4.0).distance) / 8.0, gait.speed, 0.15);
  double standing = 0.0;
  double turned = 0.0;
  for (const WalkState& state : states) {
    if (state.activity == 0.0) standing += kMotionStep;
    turned = std::max(turned, std::abs(state.turn));
  }
  EXPECT_GT(standing, 2.0);
  EXPECT_GT(turned, 40.0 * kDegree);
  EXPECT_LT(turned, 90.1 * kDegree);
}

TEST(MotionTest, AccelerationHasNoJumps) {
  const Motion motion = room_motion(gait_model("trot"), 20.0, 4);
  constexpr double kEps = 2e-5;
  const auto acceleration = [&](double time) {
    return PoseAngles((motion.body_angles(time + kEps) - 2.0 * motion.body_angles(time) +
                       motion.body_angles(time - kEps)) /
                      (kEps * kEps));
  };
  // Where the second derivative is continuous, its step shrinks with the step in time.
  double coarse = 0.0;
  double fine = 0.0;
  for (double time = 5.0; time < 6.0; time += kMotionStep) {
    coarse = std::max(coarse, (acceleration(time + 4e-4) - acceleration(time - 4e-4)).norm());
    fine = std::max(fine, (acceleration(time + 5e-5) - acceleration(time - 5e-5)).norm());
  }
  EXPECT_LT(fine, 0.25 * coarse);
}

TEST(MotionTest, StaysOverTheFloorAtItsHeight) {
  const Motion motion = room_motion(gait_model("trot"), 40.0, 6);
  for (double time = 0.0; time < 40.0; time += 0.01) {
    EXPECT_NEAR(motion.T_map_body(time).translation.z(), 0.31, 0.06);
  }
}

TEST(MotionTest, FollowsARampWithItsHeightAndPitch) {
  Scene scene;
  constexpr double kSlope = 0.15;
  scene.mesh.add_quad({-20, -20, -20 * kSlope}, {20, -20, 20 * kSlope}, {20, 20, 20 * kSlope},
                      {-20, 20, -20 * kSlope}, Material::concrete);
  scene.route = {
      {-8, -5, -8 * kSlope}, {8, -5, 8 * kSlope}, {8, 5, 8 * kSlope}, {-8, 5, -8 * kSlope}};
  const RayCaster rays(scene);
  const GroundPath path(scene, rays, Stance{}, 1.0);
  const PoseAngles uphill = path.at(8.0);
  EXPECT_NEAR(uphill(2), kSlope * uphill(0), 1e-3);
  EXPECT_NEAR(uphill(kPitch), -std::atan(kSlope), 1e-3);  // nose up is negative pitch
  EXPECT_NEAR(uphill(kRoll), 0.0, 1e-3);
  const PoseAngles across = path.at(16.0 + 4.5);
  EXPECT_NEAR(across(kYaw), 0.5 * std::numbers::pi, 0.02);
  // Walking in y, the slope falls to the left: the left side is lower.
  EXPECT_NEAR(across(kRoll), -std::atan(kSlope), 5e-3);
}

TEST(MotionTest, ARouteThatNobodyCouldWalkIsRefusedWithItsReason) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  using Route = std::vector<Eigen::Vector3d>;
  const std::vector<std::pair<Route, std::string>> cases = {
      {{{0, 0, 0}, {1, 0, 0}}, "2 corners"},
      {{{0, 0, 0}, {kInfinity, 0, 0}, {1, 1, 0}}, "corner 2"},
      {{{0, 0, 0}, {1, 0, 0}, {1, kNan, 0}}, "corner 3"},
      {{{2, 2, 0}, {2, 2, 0}, {2, 2, 0}}, "is 0 m long"},
      {{{2, 2, 0}, {2, 2, 1}, {2, 2, 2}}, "is 0 m long"},
      {{{0, 0, 0}, {0.4, 0, 0}, {0, 0.4, 0}}, "corners rounded"},  // a point when rounded
      {{{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, "100 km"},
      {{{0, 0, 0}, {1e6, 0, 0}, {0, 1e6, 0}}, "100 km"}};
  for (const auto& [route, reason] : cases) {
    Scene scene = room();
    scene.route = route;
    const RayCaster rays(scene);
    try {
      (void)make_motion(scene, rays, gait_model("trot"), 2.0, 1, kMount);
      ADD_FAILURE() << reason;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }
}

TEST(MotionTest, ARouteWithoutGroundIsRefusedByName) {
  Scene scene = room();
  scene.route[1] = {30.0, 0.0, 0.0};
  const RayCaster rays(scene);
  EXPECT_THROW((void)make_motion(scene, rays, gait_model("trot"), 5.0, 1, kMount),
               std::invalid_argument);
  scene.route.resize(2);
  EXPECT_THROW((void)make_motion(scene, rays, gait_model("trot"), 5.0, 1, kMount),
               std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::simulation::test
