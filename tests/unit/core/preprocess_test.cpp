// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What enters the odometry, eq. (1): valid points, normalised times, scans refused with a reason.
#include "core/preprocess.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "support/random.hpp"

namespace surefoot {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Config::Preprocess test_config() {
  Config::Preprocess config = Config().preprocess;
  config.min_range = 0.5;
  config.max_range = 50.0;
  config.min_points = 10;
  config.min_extent = 0.5;
  return config;
}

Scan good_scan(int points = 101) {
  test::Random random(1);
  Scan scan;
  scan.stamp_ns = 1'000'000'000;
  for (int i = 0; i < points; ++i) {
    scan.points.emplace_back(random.uniform(1.0, 20.0), random.uniform(-5.0, 5.0), 0.0);
    scan.intensities.push_back(static_cast<float>(i));
    scan.times_ns.push_back(1000 * i);
  }
  return scan;
}

TEST(Preprocess, TimesBecomeSharesOfTheScan) {
  Scan scan = good_scan();
  for (const std::int32_t first : {0, -100'000, -40'000, 2'000'000'000}) {
    for (int i = 0; i <= 100; ++i) scan.times_ns[static_cast<std::size_t>(i)] = first + 1000 * i;
    const PreparedScan prepared = preprocess(scan, test_config());
    ASSERT_EQ(prepared.rejection, "");
    EXPECT_EQ(prepared.start_ns, 1'000'000'000 + std::int64_t{first});
    EXPECT_EQ(prepared.end_ns - prepared.start_ns, 100'000);
    for (std::size_t i = 0; i <= 100; ++i) {
      EXPECT_FLOAT_EQ(prepared.taus[i], static_cast<float>(i) / 100.0F);
    }
  }
}

/// A driver may send the points ring by ring, or backwards.
TEST(Preprocess, TheFirstInstantIsFoundWhereverItStands) {
  Scan scan = good_scan();
  std::swap(scan.times_ns.front(), scan.times_ns[60]);
  std::swap(scan.times_ns.back(), scan.times_ns[40]);
  const PreparedScan prepared = preprocess(scan, test_config());
  ASSERT_EQ(prepared.rejection, "");
  EXPECT_EQ(prepared.start_ns, 1'000'000'000);
  EXPECT_EQ(prepared.end_ns, 1'000'100'000);
  EXPECT_EQ(prepared.taus[60], 0.0F);
  EXPECT_EQ(prepared.taus[40], 1.0F);
}

TEST(Preprocess, ThrowsOutNoReturnsAndRangesAndKeepsTheRestInStep) {
  Scan scan = good_scan();
  scan.points[3] = {kNaN, 1.0F, 1.0F};
  scan.points[4] = {1.0F, kInfinity, 1.0F};
  scan.points[5] = {1.0F, 1.0F, -kInfinity};
  scan.points[6] = Eigen::Vector3f::Zero();
  scan.points[7] = {0.49F, 0.0F, 0.0F};
  scan.points[8] = {50.01F, 0.0F, 0.0F};
  scan.points[9] = {0.5F, 0.0F, 0.0F};
  scan.points[10] = {0.0F, -50.0F, 0.0F};
  scan.points[11] = {3e38F, 3e38F, 3e38F};  // its square overflows a float
  const PreparedScan prepared = preprocess(scan, test_config());
  ASSERT_EQ(prepared.rejection, "");
  ASSERT_EQ(prepared.points.size(), 94U);
  ASSERT_EQ(prepared.taus.size(), 94U);
  ASSERT_EQ(prepared.intensities.size(), 94U);
  EXPECT_EQ(prepared.points[3], scan.points[9]);
  EXPECT_EQ(prepared.points[4], scan.points[10]);
  EXPECT_EQ(prepared.intensities[3], 9.0F);
  EXPECT_FLOAT_EQ(prepared.taus[3], 0.09F);
}

TEST(Preprocess, ZeroPointsAreNoReturnsWithoutAMinimumRangeToo) {
  Config::Preprocess config = test_config();
  config.min_range = 0.0;
  Scan scan = good_scan();
  scan.points[0].setZero();
  EXPECT_EQ(preprocess(scan, config).points.size(), 100U);
}

// A driver that puts the LiDAR's offset, or rounds, on the way from no return to a point.
TEST(Preprocess, PointsWithinAMillimetreOfTheSensorAreNoReturns) {
  Config::Preprocess config = test_config();
  config.min_range = 0.0;
  Scan scan = good_scan();
  scan.points[0] = {1e-4F, 0.0F, 0.0F};
  scan.points[1] = {5e-4F, -5e-4F, 5e-4F};
  scan.points[2] = {0.0F, 0.0F, -2e-3F};
  const PreparedScan prepared = preprocess(scan, config);
  ASSERT_EQ(prepared.points.size(), 99U);
  EXPECT_EQ(prepared.points[0], scan.points[2]);
}

TEST(Preprocess, IntervalCountsPointsThatAreThrownOut) {
  Scan scan = good_scan();
  scan.points.front().setZero();
  scan.points.back().setConstant(kNaN);
  const PreparedScan prepared = preprocess(scan, test_config());
  EXPECT_EQ(prepared.start_ns, 1'000'000'000);
  EXPECT_EQ(prepared.end_ns, 1'000'100'000);
}

TEST(Preprocess, EqualOrMissingTimesMeanThereIsNothingToDeskew) {
  Scan scan = good_scan();
  scan.times_ns.assign(scan.points.size(), -7);
  EXPECT_TRUE(preprocess(scan, test_config()).taus.empty());
  EXPECT_EQ(preprocess(scan, test_config()).start_ns, 999'999'993);
  scan.times_ns.clear();
  const PreparedScan prepared = preprocess(scan, test_config());
  EXPECT_TRUE(prepared.taus.empty());
  EXPECT_EQ(prepared.rejection, "");
  EXPECT_EQ(prepared.start_ns, prepared.end_ns);
}

TEST(Preprocess, ArraysOfOtherLengthsAreRefusedNamingBoth) {
  Scan scan = good_scan();
  scan.times_ns.pop_back();
  const PreparedScan refused = preprocess(scan, test_config());
  EXPECT_NE(refused.rejection.find("stamp 1000000000 ns has 100 times for 101 points"),
            std::string::npos)
      << refused.rejection;
  EXPECT_EQ(refused.mid_ns(), scan.stamp_ns);
  scan = good_scan();
  scan.intensities.push_back(0.0F);
  EXPECT_NE(preprocess(scan, test_config()).rejection.find("102 intensities for 101 points"),
            std::string::npos);
}

TEST(Preprocess, TooFewPointsAreRefusedNamingSeenAndExpected) {
  for (const int points : {0, 1, 9}) {
    const std::string rejection = preprocess(good_scan(points), test_config()).rejection;
    EXPECT_NE(rejection.find(std::to_string(points) + " valid points of " + std::to_string(points)),
              std::string::npos);
    EXPECT_NE(rejection.find("at least 10"), std::string::npos);
  }
  EXPECT_EQ(preprocess(good_scan(10), test_config()).rejection, "");
}

TEST(Preprocess, PointsInOnePlaceAreRefused) {
  Scan scan = good_scan();
  scan.points.assign(scan.points.size(), {1.0F, 2.0F, 3.0F});
  EXPECT_NE(preprocess(scan, test_config()).rejection.find("extent"), std::string::npos);
}

}  // namespace
}  // namespace surefoot
