// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/whole_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/random.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {
namespace {

using test::Random;

/// Three walls at a distance that every scan has otherwise, by metres: no motion explains that.
PreparedScan scan_of_corners(Random& random, std::int64_t number) {
  constexpr int kPoints = 3000;
  PreparedScan scan;
  scan.start_ns = number * 100'000'000;
  scan.end_ns = scan.start_ns + 100'000'000;
  const double distance = 3.0 + random.uniform(-3.0, 3.0);
  for (int i = 0; i < kPoints; ++i) {
    const double u = random.uniform(-4.0, 4.0), v = random.uniform(-4.0, 4.0);
    const double d = distance + random.normal(0.3);
    const Eigen::Vector3d walls[3] = {{d, u, v}, {u, d, v}, {u, v, -d}};
    scan.points.push_back(walls[i % 3].cast<float>());
    scan.taus.push_back(static_cast<float>(i) / (kPoints - 1));
  }
  return scan;
}

/// The pose sways within the scan, as a trot does.
Estimate swaying_from(const PreparedScan& scan, double x) {
  std::vector<Pose> boundaries;
  for (int k = 0; k <= 12; ++k) {
    boundaries.push_back({from_roll_pitch_yaw({0.0, 0.02 * std::sin(0.5 * k), 0.0}),
                          {x + 0.01 * k, 0.02 * std::sin(0.5 * k), 0.0}});
  }
  Estimate estimate;
  estimate.trajectory = ScanTrajectory(boundaries, scan.start_ns, scan.end_ns);
  return estimate;
}

double apart(const ScanTrajectory& a, const ScanTrajectory& b, double at) {
  return (a.at(at).translation - b.at(at).translation).norm();
}

// What the sensor did in a gap nobody knows: a few knots across it would leave none for the scan.
TEST(WholeWay, AScanAfterAGapMovesByItselfOneWithoutGoesOn) {
  const Session session{Config{}, Workers(1)};
  for (const double gap_s : {0.0, 2.0}) {
    WholeWay way(session);
    std::vector<Estimate> told;
    for (int number = 0; number < 2; ++number) {
      PreparedScan scan;
      scan.start_ns = number * (100'000'000 + std::llround(1e9 * gap_s));
      scan.end_ns = scan.start_ns + 100'000'000;
      told.push_back(swaying_from(scan, 0.3 * number));
      ASSERT_TRUE(way.add(std::move(scan), told.back()));
    }
    const ScanTrajectory second = way.trajectory(1);
    for (const double at : {0.25, 0.5, 0.75, 1.0}) {
      EXPECT_LT(apart(second, told[1].trajectory, at), 0.003) << gap_s << ' ' << at;
    }
    const double begins_apart = apart(second, told[1].trajectory, 0.0);
    if (gap_s > 0.0) {
      EXPECT_LT(begins_apart, 0.003);
    } else {
      EXPECT_NEAR(begins_apart, 0.3 - 0.12, 0.02) << "where the first one ended";
    }
  }
}

std::vector<Pose> middles_of(const WholeWay& way) {
  std::vector<Pose> middles;
  for (std::size_t s = 0; s < way.size(); ++s) middles.push_back(way.trajectory(s).at(0.5));
  return middles;
}

// Of some the first step is one that a robot can have made, and the next is not.
TEST(WholeWay, WhatCannotBeRefinedStaysWhereItWas) {
  int refused = 0;
  for (const std::uint64_t seed : {215U, 321U, 393U}) {
    Random random(seed);
    Config config;
    config.knots.finest_voxel = random.uniform(2.0, 10.0);
    config.knots.levels = 2;
    config.knots.divided_at = 0;
    config.knots.noise = 1.0;
    const Session session{config, Workers(1)};
    WholeWay way(session);
    for (int number = 0; number < 4; ++number) {
      PreparedScan scan = scan_of_corners(random, number);
      Estimate estimate;
      estimate.trajectory = ScanTrajectory({Pose{}, Pose{}}, scan.start_ns, scan.end_ns);
      (void)way.add(std::move(scan), estimate);
    }
    const std::vector<Pose> before = middles_of(way);
    if (way.refine()) continue;
    ++refused;
    const std::vector<Pose> after = middles_of(way);
    for (std::size_t s = 0; s < before.size(); ++s) {
      EXPECT_EQ(after[s].translation, before[s].translation) << seed;
    }
  }
  EXPECT_GT(refused, 0);
}

constexpr std::int64_t kLasting = 100'000'000;  // [ns]
constexpr int kWallPoints = 6000;

/// What a sensor that goes along x at a steady speed sees of a tunnel, or of a room of 6 m, so far
/// beside the walls as the noise has it [m].
PreparedScan walls_around(Random& random, std::int64_t start_ns, std::int64_t lasts_ns,
                          double speed, double noise, bool room) {
  PreparedScan scan;
  scan.start_ns = start_ns;
  scan.end_ns = start_ns + lasts_ns;
  for (int i = 0; i < kWallPoints; ++i) {
    const double tau = static_cast<double>(i) / (kWallPoints - 1);
    const double x =
        1e-9 * speed * (static_cast<double>(start_ns) + tau * static_cast<double>(lasts_ns));
    const double u = random.uniform(-3.0, 3.0), v = random.uniform(-3.0, 3.0);
    const double d = (i % 2 == 0 ? 3.0 : -3.0) + random.normal(noise);
    const Eigen::Vector3d of_room[3] = {{d, u, v}, {u, d, v}, {u, v, d}};
    Eigen::Vector3d point = of_room[room ? i % 3 : 1 + i / 2 % 2];
    if (!room) point.x() = 3.0 * u;
    if (room) point.x() -= x;
    scan.points.push_back(point.cast<float>());
    scan.taus.push_back(static_cast<float>(tau));
  }
  return scan;
}

Estimate going_along_x(const PreparedScan& scan, double speed, double beside = 0.0) {
  const auto at = [&](std::int64_t time_ns) {
    return Pose{Eigen::Quaterniond::Identity(),
                {1e-9 * speed * static_cast<double>(time_ns), beside, 0.0}};
  };
  Estimate estimate;
  estimate.trajectory =
      ScanTrajectory({at(scan.start_ns), at(scan.end_ns)}, scan.start_ns, scan.end_ns);
  return estimate;
}

/// Of a third of the points each axis is told, by as many independent distances from a wall.
TEST(WholeWay, AMiddleIsKnownAboutAsWellAsItsPointsTell) {
  constexpr double kNoise = 0.03;
  const Session session{Config{}, Workers(1)};
  Random random(5);
  WholeWay way(session);
  for (int number = 0; number < 2; ++number) {
    PreparedScan scan = walls_around(random, number * kLasting, kLasting, 0.0, kNoise, true);
    const Estimate estimate = going_along_x(scan, 0.0);
    ASSERT_TRUE(way.add(std::move(scan), estimate));
  }
  ASSERT_TRUE(way.refine());
  for (int axis = 0; axis < 3; ++axis) {
    const double told = kNoise * kNoise / (kWallPoints / 3.0);
    EXPECT_GT(way.covariance(0)(axis, axis), told);
    EXPECT_LT(way.covariance(0)(axis, axis), 1.7 * told);
  }
}

/// No wall tells how far along it the sensor is, but that it goes steadily shows in what was
/// walked.
TEST(WholeWay, ASteadyWalkThroughATunnelStaysOne) {
  const Session session{Config{}, Workers(1)};
  Random random(6);
  WholeWay way(session);
  std::int64_t start_ns = 0;
  std::vector<Estimate> told;
  for (int number = 0; number < 10; ++number) {
    const std::int64_t lasts_ns = number % 2 == 0 ? kLasting / 2 : 2 * kLasting;
    PreparedScan scan = walls_around(random, start_ns, lasts_ns, 1.0, 0.01, false);
    told.push_back(going_along_x(scan, 1.0));
    ASSERT_TRUE(way.add(std::move(scan), told.back()));
    start_ns += lasts_ns;
  }
  for (int pass = 0; pass < 3; ++pass) ASSERT_TRUE(way.refine());
  for (std::size_t s = 0; s < told.size(); ++s) {
    for (const double at : {0.0, 0.5, 1.0}) {
      EXPECT_LT(apart(way.trajectory(s), told[s].trajectory, at), 0.1) << s << ' ' << at;
    }
    const ScanTrajectory motion = way.trajectory(s);
    const double step =
        seconds(motion.end_ns() - motion.start_ns()) / static_cast<double>(motion.segments());
    for (std::size_t k = 0; k < motion.segments(); ++k) {
      const Pose &from = motion.boundary(k), &to = motion.boundary(k + 1);
      EXPECT_NEAR((to.translation - from.translation).x() / step, 1.0, 1.2) << s << ' ' << k;
    }
  }
}

/// Three times as many as of a scan are enough for all of a gap.
TEST(WholeWay, AGapThatIsBridgedTakesSoManyKnotsAndNoMore) {
  Config config;
  config.motion_prior.max_extrapolation = 2.0;
  const Session session{config, Workers(1)};
  const auto usual = static_cast<std::size_t>(config.knots.segments);
  for (const auto& [gap_s, expected] :
       {std::pair{0.0, usual}, {0.1, 2 * usual}, {1.9, 3 * usual}}) {
    WholeWay way(session);
    for (int number = 0; number < 2; ++number) {
      PreparedScan scan;
      scan.start_ns = number * (kLasting + std::llround(1e9 * gap_s));
      scan.end_ns = scan.start_ns + kLasting;
      const Estimate estimate = going_along_x(scan, 0.0);
      ASSERT_TRUE(way.add(std::move(scan), estimate));
    }
    EXPECT_EQ(way.trajectory(0).segments(), usual);
    EXPECT_EQ(way.trajectory(1).segments(), expected) << gap_s;
  }
}

/// Of a sensor without times of points, say.
TEST(WholeWay, ItMayBeginWithAScanOfAnInstant) {
  const Session session{Config{}, Workers(1)};
  Random random(9);
  WholeWay way(session);
  for (const std::int64_t lasts_ns : {std::int64_t{0}, kLasting}) {
    PreparedScan scan = walls_around(random, 0, lasts_ns, 0.0, 0.01, true);
    const Estimate estimate = going_along_x(scan, 0.0);
    ASSERT_TRUE(way.add(std::move(scan), estimate));
  }
  ASSERT_TRUE(way.refine());
  EXPECT_LT(apart(way.trajectory(0), way.trajectory(1), 0.5), 0.01);
}

/// Every other scan begins 0.1 m beside the rest: the second map is a sharp one.
TEST(WholeWay, IsMappedAnewWhereItLiesNow) {
  const Session session{Config{}, Workers(1)};
  Random random(7);
  WholeWay way(session);
  for (int number = 0; number < 6; ++number) {
    PreparedScan scan = walls_around(random, number * kLasting, kLasting, 0.0, 0.005, true);
    const Estimate estimate = going_along_x(scan, 0.0, number % 2 == 0 ? 0.0 : 0.1);
    ASSERT_TRUE(way.add(std::move(scan), estimate));
  }
  for (int pass = 0; pass < 2; ++pass) ASSERT_TRUE(way.refine());
  for (std::size_t s = 1; s < way.size(); ++s) {
    EXPECT_LT(apart(way.trajectory(s), way.trajectory(0), 0.5), 0.004) << s;
  }
}

TEST(WholeWay, AScanThatEndsWithTheOneBeforeIsNotOfTheChain) {
  const Session session{Config{}, Workers(1)};
  Random random(8);
  WholeWay way(session);
  const auto add = [&](std::int64_t start_ns, std::int64_t lasts_ns) {
    PreparedScan scan = walls_around(random, start_ns, lasts_ns, 0.0, 0.01, true);
    const Estimate estimate = going_along_x(scan, 0.0);
    return way.add(std::move(scan), estimate);
  };
  EXPECT_TRUE(add(0, kLasting));
  EXPECT_FALSE(add(0, kLasting));
  EXPECT_FALSE(add(kLasting / 100, kLasting)) << "less than a segment more";
  EXPECT_TRUE(add(kLasting, kLasting));
  EXPECT_EQ(way.size(), 2U);
}

}  // namespace
}  // namespace surefoot
