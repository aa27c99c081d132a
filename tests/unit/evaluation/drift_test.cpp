// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/drift.hpp"

#include <gtest/gtest.h>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::moved;
using test::stamped;
using test::straight_walk;

TEST(EndDrift, IsTakenWithTheFirstPosesMadeToCoincide) {
  const Trajectory reference = straight_walk(11, 1.0);
  Trajectory estimate = reference;
  for (std::size_t i = 0; i < 11; ++i) {
    estimate[i].pose.translation += 0.1 * static_cast<double>(i) * Eigen::Vector3d(0.3, 0.0, -0.4);
  }
  const Pose elsewhere{from_roll_pitch_yaw({0.2, 0.1, 3.0}), {50.0, 60.0, 70.0}};
  const EndDrift drift = end_drift({reference, moved(estimate, elsewhere)});
  EXPECT_NEAR(drift.path_length, 10.0, 1e-12);
  EXPECT_NEAR(drift.total, 0.5, 1e-9);
  EXPECT_NEAR(drift.horizontal, 0.3, 1e-9);
  EXPECT_NEAR(drift.vertical, -0.4, 1e-9) << "too low";
  EXPECT_NEAR(drift.percent, 5.0, 1e-9);
}

TEST(EndDrift, OfARunThatDoesNotMove) {
  const Trajectory standing = straight_walk(5, 0.0);
  EXPECT_DOUBLE_EQ(end_drift({standing, standing}).percent, 0.0);
  // A truth that trembles in its last digits has gone nowhere either.
  Trajectory moved = standing;
  moved.back().pose.translation.x() += 0.001;
  Trajectory trembling = standing;
  for (std::size_t i = 0; i < trembling.size(); ++i) {
    trembling[i].pose.translation.y() += 1e-9 * static_cast<double>(i);
  }
  const EndDrift drift = end_drift({trembling, moved});
  EXPECT_NEAR(drift.total, 0.001, 1e-6);
  EXPECT_DOUBLE_EQ(drift.percent, 0.0);
}

TEST(PathLengths, AreSummed) {
  const Trajectory walk = {stamped(0, {0, 0, 0}), stamped(1, {3, 4, 0}), stamped(2, {3, 4, 2})};
  EXPECT_EQ(path_lengths(walk), (std::vector<double>{0.0, 5.0, 7.0}));
  EXPECT_TRUE(path_lengths({}).empty());
}

Trajectory at_rate(double from, double to, double step) {
  Trajectory trajectory;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) {
    trajectory.push_back(stamped(from + i * step, Eigen::Vector3d::Zero()));
  }
  return trajectory;
}

TEST(Coverage, OfAWholeRunAndOfOneThatStopsEarly) {
  const Trajectory truth = at_rate(100.0, 110.0, 0.005);
  EXPECT_NEAR(coverage(truth, at_rate(100.0, 110.0, 0.1), 0.0), 1.0, 1e-9);
  EXPECT_NEAR(coverage(truth, at_rate(100.0, 104.0, 0.1), 0.0), 0.4, 1e-9);
  EXPECT_NEAR(coverage(truth, at_rate(95.0, 105.0, 0.1), 0.0), 0.5, 1e-9);
  EXPECT_NEAR(coverage(truth, at_rate(0.0, 10.0, 0.1), 0.0), 0.0, 1e-9);
  EXPECT_NEAR(coverage(truth, at_rate(0.0, 10.0, 0.1), 100.0), 1.0, 1e-9);
}

TEST(Coverage, AHoleInTheEstimateIsNotCoveredButADroppedScanIs) {
  const Trajectory truth = at_rate(0.0, 10.0, 0.01);
  Trajectory estimate = at_rate(0.0, 4.0, 0.1);
  const Trajectory rest = at_rate(6.0, 10.0, 0.1);
  estimate.insert(estimate.end(), rest.begin(), rest.end());
  EXPECT_NEAR(coverage(truth, estimate, 0.0), 0.8, 1e-9);
  Trajectory dropped = at_rate(0.0, 10.0, 0.1);
  dropped.erase(dropped.begin() + 50);
  EXPECT_NEAR(coverage(truth, dropped, 0.0), 1.0, 1e-9);
}

// Of every four scans one has a pose: the poses alone look like a slower sensor's.
TEST(Coverage, PosesThatAreMissingEverywhereAreHoles) {
  const Trajectory truth = at_rate(0.0, 10.0, 0.01), sparse = at_rate(0.0, 10.0, 0.4);
  EXPECT_NEAR(coverage(truth, sparse, 0.0), 1.0, 1e-9);
  EXPECT_NEAR(coverage(truth, sparse, 0.0, 100'000'000), 0.0, 1e-9);
}

TEST(Coverage, OfStampsThatComeTwice) {
  const Trajectory truth = at_rate(0.0, 10.0, 0.01);
  Trajectory twice;
  for (const StampedPose& pose : at_rate(0.0, 10.0, 0.1)) twice.insert(twice.end(), 3, pose);
  EXPECT_NEAR(coverage(truth, twice, 0.0), 1.0, 1e-9);
}

TEST(Coverage, OfNothingAndOfAnInstant) {
  const Trajectory instant = {stamped(1.0, {0.0, 0.0, 0.0})};
  EXPECT_DOUBLE_EQ(coverage(instant, {}, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(coverage({}, instant, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(coverage(instant, instant, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(coverage(instant, instant, 0.5), 0.0);
}

}  // namespace
}  // namespace surefoot::evaluation
