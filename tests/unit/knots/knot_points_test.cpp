// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/knot_points.hpp"

#include <gtest/gtest.h>

namespace surefoot {
namespace {

/// A square floor about the sensor, one point every `spacing` [m].
PreparedScan floor_of(double side, double spacing) {
  PreparedScan scan;
  for (double x = -0.5 * side; x < 0.5 * side; x += spacing) {
    for (double y = -0.5 * side; y < 0.5 * side; y += spacing) {
      scan.points.push_back(Eigen::Vector3d(x, y, -0.5).cast<float>());
    }
  }
  return scan;
}

const PointChoice::Cubes kCubes{0.1, 1.0, 3.0};

TEST(PointChoice, TheCubesFollowTheScenesScale) {
  PointChoice choice(1000, kCubes);
  for (const double side : {6.0, 40.0, 12.0}) {
    const PreparedScan scan = floor_of(side, side / 200.0);
    std::size_t chosen = 0;
    for (int i = 0; i < 6; ++i) chosen = choice.choose(scan, Workers(1)).size();
    EXPECT_GT(chosen, 800U) << side;
    EXPECT_LT(chosen, 1250U) << side;
  }
}

TEST(PointChoice, CubesStayWithinTheirBounds) {
  PointChoice greedy(100'000, kCubes), modest(1, kCubes);
  const PreparedScan scan = floor_of(9.0, 0.05);
  std::size_t many = 0, few = 0;
  for (int i = 0; i < 8; ++i) {
    many = greedy.choose(scan, Workers(1)).size();
    few = modest.choose(scan, Workers(1)).size();
  }
  EXPECT_NEAR(static_cast<double>(many), 8100.0, 200.0);  // cubes of 0.1 m
  EXPECT_LE(few, 16U);                                    // of 3 m
}

TEST(PointChoice, AmongCandidatesItNamesTheScansPoints) {
  const PreparedScan scan = floor_of(6.0, 0.1);
  std::vector<std::uint32_t> odd;
  for (std::uint32_t i = 1; i < scan.points.size(); i += 2) odd.push_back(i);
  PointChoice choice(100, kCubes);
  for (const std::uint32_t i : choice.choose(scan, odd, Workers(1))) {
    EXPECT_EQ(i % 2, 1U);
    EXPECT_LT(i, scan.points.size());
  }
}

TEST(PointChoice, ThreadsDoNotChangeIt) {
  const PreparedScan scan = floor_of(20.0, 0.05);
  PointChoice one(500, kCubes), two(500, kCubes);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(one.choose(scan, Workers(1)), two.choose(scan, Workers(2)));
  }
}

}  // namespace
}  // namespace surefoot
