// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/whole_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "support/random.hpp"

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

}  // namespace
}  // namespace surefoot
