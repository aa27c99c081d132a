// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_points.hpp"

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
  EXPECT_LE(few, 16U);                                    // of 3 m, or larger
}

TEST(PointChoice, OfADenseScanTheCoarsestCubesAreLargerIfFourTimesTooManyWereLeft) {
  const PointChoice::Cubes cubes{0.1, 0.2, 0.2};
  const PreparedScan scan = floor_of(9.0, 0.05);  // 2,025 cubes of 0.2 m
  PointChoice enough(600, cubes), dense(300, cubes);
  std::size_t all = 0, fewer = 0;
  for (int i = 0; i < 8; ++i) {
    all = enough.choose(scan, Workers(1)).size();
    fewer = dense.choose(scan, Workers(1)).size();
  }
  EXPECT_NEAR(static_cast<double>(all), 2025.0, 100.0);
  EXPECT_NEAR(static_cast<double>(fewer), 1200.0, 120.0);
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

// The window begins where the scan before ended: here 25 ms before the scan, whose eight points lie
// 10 ms apart. Four segments of 25 ms and a bit hold them.
TEST(KnotPoints, AreSortedByTheirInstantsInTheWindow) {
  PreparedScan scan;
  scan.start_ns = 1'000'000'000;
  scan.end_ns = 1'070'000'000;
  for (int i = 0; i < 8; ++i) {
    scan.points.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
    scan.taus.push_back(static_cast<float>(i) / 7.0F);
  }
  KnotWindow window{{}, 0.02, 0.095 / 4.0, 975'000'000, 1'070'000'000};
  window.knots.resize(6);
  const KnotPoints points = sort_points(scan, {0, 1, 2, 3, 4, 5, 6, 7}, window);
  ASSERT_EQ(points.begins.size(), 5U);
  ASSERT_EQ(points.points.size(), 8U);
  for (std::size_t s = 0; s < 4; ++s) {
    for (std::size_t i = points.begins[s]; i < points.begins[s + 1]; ++i) {
      const KnotPoints::Point& point = points.points[i];
      const double since_window = 0.025 + 0.01 * point.position.x();  // [s]
      EXPECT_NEAR((static_cast<double>(s) + point.share) * window.step, since_window, 1e-7);
    }
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
