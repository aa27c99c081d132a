// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random.hpp"

namespace surefoot {
namespace {

using test::Random;

constexpr double kPi = std::numbers::pi;

Twist with_angle(Random& random, double angle) {
  Twist twist;
  twist << random.vector(10.0), angle * random.unit_vector();
  return twist;
}

TEST(KnotDifference, UndoesDisplacementAndIsUndoneByIt) {
  Random random(1);
  for (const double angle : {0.0, 1e-8, 1e-4, 0.3, 1.0, 2.5, 3.1, kPi - 1e-5}) {
    for (int i = 0; i < 50; ++i) {
      const Pose pose = random.pose(20.0, 3.0);
      const Twist by = with_angle(random, angle);
      const Pose moved = displaced(pose, by);
      EXPECT_LT((difference(moved, pose) - by).norm(), 1e-9) << angle;
      const Pose back = displaced(pose, difference(moved, pose));
      EXPECT_LT((back.matrix() - moved.matrix()).norm(), 1e-12) << angle;
    }
  }
}

TEST(KnotDifference, IsInTheMapsAxes) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose pose = random.pose(20.0, 3.0);
    const Twist by = random.twist(5.0, 1.0);
    const Pose moved = displaced(pose, by);
    EXPECT_LT((moved.translation - pose.translation - by.head<3>()).norm(), 1e-12);
    const Eigen::Matrix3d expected =
        Eigen::AngleAxisd(by.tail<3>().norm(), by.tail<3>().normalized()) *
        pose.rotation.toRotationMatrix();
    EXPECT_LT((moved.rotation.toRotationMatrix() - expected).norm(), 1e-12);
    EXPECT_NEAR(moved.rotation.norm(), 1.0, 1e-15);
  }
}

/// Nine knots at a constant velocity [m/s, rad/s, map axes], the first step longer.
KnotWindow steady(const Pose& first, const Twist& velocity) {
  KnotWindow window{{first}, 0.02, 0.0125, 5'000'000'000, 5'087'500'000};
  for (int k = 0; k < 8; ++k) {
    const double step = k == 0 ? window.first_step : window.step;
    window.knots.push_back(displaced(window.knots.back(), step * velocity));
  }
  return window;
}

TEST(KnotWindow, VelocityIsThatOfItsMaking) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Twist velocity = random.twist(2.0, 2.0);
    const KnotWindow window = steady(random.pose(20.0, 3.0), velocity);
    ASSERT_EQ(window.segments(), 7U);
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_EQ(window.duration(k), k == 0 ? 0.02 : 0.0125);
      EXPECT_LT((window.velocity(k) - velocity).norm(), 1e-11);
    }
    EXPECT_LT((window.mean_velocity() - velocity).norm(), 1e-12);
  }
}

TEST(KnotWindow, AtAVelocityItGoesOnFromItsFirstTwoKnots) {
  Random random(5);
  const KnotWindow window = steady(random.pose(20.0, 3.0), random.twist(2.0, 2.0));
  const Twist velocity = random.twist(2.0, 2.0);
  const KnotWindow moved = window.at_velocity(velocity);
  ASSERT_EQ(moved.knots.size(), window.knots.size());
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(moved.knots[k].matrix(), window.knots[k].matrix());
  }
  for (std::size_t k = 1; k < 8; ++k) EXPECT_LT((moved.velocity(k) - velocity).norm(), 1e-11);
}

TEST(KnotWindow, AfterASegmentItGoesOnAsThatOneDid) {
  Random random(6);
  KnotWindow window = steady(random.pose(20.0, 3.0), random.twist(2.0, 2.0));
  for (Pose& knot : window.knots) knot = displaced(knot, random.twist(0.02, 0.02));
  for (const std::size_t segment : {0U, 3U, 6U}) {
    const Twist own = window.velocity(segment + 1), change = own - window.velocity(segment);
    const KnotWindow steadily = window.going_on_after(segment, false);
    const KnotWindow changing = window.going_on_after(segment, true);
    ASSERT_EQ(steadily.knots.size(), window.knots.size());
    for (std::size_t k = 0; k <= segment + 2; ++k) {
      EXPECT_EQ(steadily.knots[k].matrix(), window.knots[k].matrix());
      EXPECT_EQ(changing.knots[k].matrix(), window.knots[k].matrix());
    }
    for (std::size_t k = segment + 2; k < 8; ++k) {
      const auto later = static_cast<double>(k - segment - 1);
      EXPECT_LT((steadily.velocity(k) - own).norm(), 1e-10);
      EXPECT_LT((changing.velocity(k) - own - later * change).norm(), 1e-10);
    }
  }
}

TEST(KnotWindow, TrajectoryIsTheNewScansPartOfIt) {
  Random random(4);
  KnotWindow window = steady(random.pose(20.0, 3.0), random.twist(2.0, 2.0));
  for (Pose& knot : window.knots) knot = displaced(knot, random.twist(0.02, 0.02));
  const ScanTrajectory trajectory = window.trajectory();
  EXPECT_EQ(trajectory.start_ns(), window.begin_ns);
  EXPECT_EQ(trajectory.end_ns(), window.end_ns);
  ASSERT_EQ(trajectory.segments(), window.segments());
  for (std::size_t k = 1; k < window.knots.size(); ++k) {
    const auto at = window.begin_ns + static_cast<std::int64_t>(k - 1) * 12'500'000;
    EXPECT_LT((trajectory.at_time(at).matrix() - window.knots[k].matrix()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace surefoot
