// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

using Cell = std::tuple<int, int, int, int>;

Cell sampling_cell_of(const Eigen::Vector3d& point, double size, bool floor, int group = 0) {
  const auto index = [&](double x) {
    return static_cast<int>(floor ? std::floor(x / size) : std::trunc(x / size));
  };
  return {group, index(point.x()), index(point.y()), index(point.z())};
}

PreparedScan random_scan(int points, double size) {
  test::Random random(1);
  PreparedScan scan;
  for (int i = 0; i < points; ++i) {
    scan.points.push_back(random.vector(size).cast<float>());
    scan.taus.push_back(static_cast<float>(i) / static_cast<float>(points - 1));
  }
  return scan;
}

TEST(CtIcpSampling, KeepsOnePointOfEveryCellWithItsTime) {
  const PreparedScan scan = random_scan(5000, 4.0);
  for (const bool floor : {false, true}) {
    CtIcpParameters config = test::default_parameters<CtIcpParameters>();
    config.floor_voxels = floor;
    std::set<Cell> expected, seen;
    for (const auto& point : scan.points) {
      expected.insert(sampling_cell_of(point.cast<double>(), 0.7, floor));
    }
    for (const CtIcpPoint& kept : CtIcpSampler(config).thin(scan, false, 0.7)) {
      EXPECT_TRUE(seen.insert(sampling_cell_of(kept.point, 0.7, floor)).second);
      const auto index = static_cast<std::size_t>(std::lround(kept.alpha * 4999.0));
      EXPECT_EQ(scan.points[index].cast<double>(), kept.point);
    }
    EXPECT_EQ(seen, expected);
  }
}

TEST(CtIcpSampling, ChanceIsTheSameInEveryRunAndAnotherInEveryScan) {
  const PreparedScan scan = random_scan(3000, 4.0);
  const CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  CtIcpSampler one(config), other(config);
  const auto first = one.thin(scan, false, 0.5), second = one.thin(scan, false, 0.5);
  const auto again = other.thin(scan, false, 0.5);
  ASSERT_EQ(first.size(), again.size());
  ASSERT_EQ(first.size(), second.size());
  int moved = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].point, again[i].point);
    moved += first[i].point != second[i].point ? 1 : 0;
  }
  EXPECT_GT(moved, 0);
}

TEST(CtIcpSampling, RigidScansAreOfTheLastInstant) {
  PreparedScan scan = random_scan(500, 4.0);
  const CtIcpParameters config = test::default_parameters<CtIcpParameters>();
  for (const auto& kept : CtIcpSampler(config).thin(scan, true, 0.5)) EXPECT_EQ(kept.alpha, 1.0);
  scan.taus.clear();
  for (const auto& kept : CtIcpSampler(config).thin(scan, false, 0.5)) EXPECT_EQ(kept.alpha, 1.0);
}

TEST(CtIcpSampling, KeypointsAreAsManyAsAllowed) {
  const PreparedScan scan = random_scan(3000, 10.0);
  for (const auto sampling : {CtIcpSampling::none, CtIcpSampling::grid, CtIcpSampling::adaptive}) {
    CtIcpParameters config = test::default_parameters<CtIcpParameters>();
    config.sampling = sampling;
    config.max_num_keypoints = 200;
    CtIcpSampler sampler(config);
    const auto points = sampler.thin(scan, false, 0.5);
    EXPECT_EQ(sampler.keypoints(points, 1.0, true).size(), 200U);
    const auto all = sampler.keypoints(points, 1.0, false);
    if (sampling == CtIcpSampling::none) {
      EXPECT_EQ(all.size(), points.size());
    }
    EXPECT_GT(all.size(), 200U);
  }
}

TEST(CtIcpSampling, AdaptiveCellsGrowWithTheDistance) {
  test::Random random(2);
  std::vector<CtIcpPoint> points;
  for (int i = 0; i < 20000; ++i) {
    points.push_back({random.uniform(0.1, 210.0) * random.unit_vector(), 0.5});
  }
  points.push_back({{0.5, 0.0, 0.0}, 0.5});    // on the border: the original looks for its shell
                                               // outside of the table
  points.push_back({{0.0, 200.0, 0.0}, 0.5});  // and this one is left out
  std::set<Cell> expected, seen;
  const auto add = [](std::set<Cell>& cells, const Eigen::Vector3d& point) {
    const double range = point.norm();
    if (range < 0.5 || range >= 200.0) return false;
    const int shell = range <= 2.0    ? 0
                      : range <= 4.0  ? 1
                      : range <= 8.0  ? 2
                      : range <= 16.0 ? 3
                                      : 4;
    return cells.insert(sampling_cell_of(point, 0.1 * (1 << shell), false, shell)).second;
  };
  for (const auto& point : points) add(expected, point.point);
  for (const std::size_t i : adaptive_sample(points, CellRounding::to_zero)) {
    EXPECT_TRUE(add(seen, points[i].point)) << points[i].point.transpose();
  }
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace surefoot
