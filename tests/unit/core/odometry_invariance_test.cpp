// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What must not change the result: where the world lies, the order of the points, the number of
// threads, the epoch of the stamps, running again.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <string>

#include "support/every_method.hpp"
#include "support/random.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

const Pose kInvarianceStart{Eigen::Quaterniond::Identity(), {-3.0, 0.5, 0.45}};

const std::vector<Scan>& walked_scans() {
  static const std::vector<Scan> scans =
      take_scans(furnished_hall(), trotting(kInvarianceStart, 0.8, 2.5), 15);
  return scans;
}

class OdometryInvariance : public EveryMethod {
 protected:
  static std::vector<Estimate> run(const std::vector<Scan>& scans, int threads = 1,
                                   const Pose& T_world_start = {}) {
    Odometry odometry(config(), threads, T_world_start);
    return add_scans(odometry, scans);
  }
  /// walked_scans() by this method.
  static const std::vector<Estimate>& walked() {
    static std::map<std::string, std::vector<Estimate>> of_method;
    auto& estimates = of_method[method()];
    if (estimates.empty()) estimates = run(walked_scans());
    return estimates;
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, OdometryInvariance, each_method(), method_name);

TEST_P(OdometryInvariance, TheWorldMayLieAnywhereAndBeTurned) {
  for (const double yaw : {0.0, 0.7, -3.0}) {
    const Pose T_world_start{so3_exp({0.0, 0.0, yaw}), {10'000.0, -10'000.0, 500.0}};
    const auto there = run(walked_scans(), 1, T_world_start);
    ASSERT_EQ(there.size(), walked().size());
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Pose back = T_world_start.inverse() * there[i].T_world_lidar;
      const Pose& here = walked()[i].T_world_lidar;
      EXPECT_LT((back.translation - here.translation).norm(), 1e-6);
      EXPECT_LT(so3_log(back.rotation * here.rotation.conjugate()).norm(), 1e-6);
      EXPECT_EQ(there[i].status, walked()[i].status);
      // The covariance is about the sensor, in the world's axes.
      EXPECT_NEAR(there[i].covariance.trace(), walked()[i].covariance.trace(),
                  1e-9 * walked()[i].covariance.trace());
    }
  }
}

TEST_P(OdometryInvariance, RunsRepeatBitForBit) {
  EXPECT_TRUE(same_bits(run(walked_scans()), walked()));
}

TEST_P(OdometryInvariance, ThreadsDoNotChangeABit) {
  for (const int threads : {2, 3, 8}) {
    EXPECT_TRUE(same_bits(run(walked_scans(), threads), walked())) << threads << " threads";
  }
}

TEST_P(OdometryInvariance, OrderOfThePointsDoesNotChangeABit) {
  Random random(1);
  std::vector<Scan> shuffled = walked_scans();
  for (Scan& scan : shuffled) {
    for (std::size_t i = scan.points.size(); i > 1; --i) {
      const std::size_t j = random.below(i);
      std::swap(scan.points[i - 1], scan.points[j]);
      std::swap(scan.times_ns[i - 1], scan.times_ns[j]);
      std::swap(scan.intensities[i - 1], scan.intensities[j]);
    }
  }
  EXPECT_TRUE(same_bits(run(shuffled), walked()));
}

TEST_P(OdometryInvariance, IntensitiesAndRingsAreOnlyCarried) {
  std::vector<Scan> bare = walked_scans();
  for (Scan& scan : bare) {
    scan.intensities.clear();
    scan.rings.clear();
  }
  EXPECT_TRUE(same_bits(run(bare), walked()));
}

TEST_P(OdometryInvariance, TheEpochOfTheStampsOnlyMovesTheStamps) {
  constexpr std::int64_t kHuge = 8'000'000'000'000'000'000;
  for (const std::int64_t epoch : {kHuge, -kHuge}) {
    std::vector<Scan> later = walked_scans();
    for (Scan& scan : later) scan.stamp_ns += epoch;
    const auto estimates = run(later);
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      EXPECT_EQ(estimates[i].stamp_ns, walked()[i].stamp_ns + epoch);
      EXPECT_EQ(estimates[i].T_world_lidar.translation, walked()[i].T_world_lidar.translation);
    }
  }
}

TEST_P(OdometryInvariance, PointTimesMayCountFromTheEndOfTheScan) {
  // Velodyne's driver stamps a scan with its last packet: offsets are negative.
  std::vector<Scan> from_end = walked_scans();
  for (Scan& scan : from_end) {
    scan.stamp_ns += 100'000'000;
    for (std::int32_t& time : scan.times_ns) time -= 100'000'000;
  }
  EXPECT_TRUE(same_bits(run(from_end), walked()));
}

TEST_P(OdometryInvariance, AMovedObjectGoesOn) {
  Odometry first(config());
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < 7; ++i) estimates.push_back(first.add_scan(walked_scans()[i]));
  Odometry second = std::move(first);
  for (std::size_t i = 7; i < walked_scans().size(); ++i) {
    estimates.push_back(second.add_scan(walked_scans()[i]));
  }
  EXPECT_TRUE(same_bits(estimates, walked()));
}

TEST_P(OdometryInvariance, ObserversSeeTheStepsInOrderAndChangeNothing) {
  Odometry odometry(config());
  std::vector<Step> steps;
  odometry.set_step_observer([&](Step step) { steps.push_back(step); });
  const auto estimates = add_scans(odometry, walked_scans());
  EXPECT_TRUE(same_bits(estimates, walked()));
  // Of the first scan. Only the paper's method deskews before it registers.
  std::vector<Step> first = {Step::preprocess, Step::deskew, Step::downsample, Step::map,
                             Step::idle};
  if (config().method == "surefoot") first.erase(first.begin() + 1);
  ASSERT_GT(steps.size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), steps.begin()));
  EXPECT_EQ(std::count(steps.begin(), steps.end(), Step::preprocess), std::ssize(walked_scans()));
  // Each scan but the first, once. The knots' second scan is assessed twice, as each of the first
  // two is tried on a map of the other, and four times more where the robot turns: this walk begins
  // so.
  const std::ptrdiff_t more = config().method == "surefoot" ? 1 + 4 : 0;
  EXPECT_EQ(std::count(steps.begin(), steps.end(), Step::assess),
            std::ssize(walked_scans()) - 1 + more);
  EXPECT_EQ(std::count(steps.begin(), steps.end(), Step::idle), std::ssize(walked_scans()));
  EXPECT_GT(std::count(steps.begin(), steps.end(), Step::search), std::ssize(walked_scans()) - 1);
  EXPECT_EQ(steps.back(), Step::idle);
}

}  // namespace
}  // namespace surefoot
