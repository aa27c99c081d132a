// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/alignment.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::moved;
using test::stamped;
using test::straight_walk;
using test::winding_walk;

constexpr double kScale = 1.7;
const Pose kTilted{from_roll_pitch_yaw({0.3, -0.2, 2.5}), {10.0, -4.0, 2.0}};
const Pose kTurned{from_roll_pitch_yaw({0.0, 0.0, 2.5}), {10.0, -4.0, 2.0}};

double largest_distance(const Trajectory& a, const Trajectory& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i].pose.translation - b[i].pose.translation).norm());
    largest = std::max(largest, a[i].pose.rotation.angularDistance(b[i].pose.rotation));
  }
  return largest;
}

TEST(Alignment, EachMethodUndoesTheMotionThatItKnows) {
  const Trajectory estimate = winding_walk(60);
  const auto left_over = [&](AlignmentMethod method, const Pose& motion, double scale) {
    const Trajectory reference = moved(estimate, motion, scale);
    const TrajectoryAlignment found = find_alignment({reference, estimate}, method);
    return largest_distance(aligned(estimate, found), reference);
  };
  EXPECT_LT(left_over(AlignmentMethod::none, {}, 1.0), 1e-12);
  EXPECT_LT(left_over(AlignmentMethod::origin, kTilted, 1.0), 1e-9);
  EXPECT_LT(left_over(AlignmentMethod::yaw_translation, kTurned, 1.0), 1e-9);
  EXPECT_LT(left_over(AlignmentMethod::rigid, kTilted, 1.0), 1e-9);
  EXPECT_LT(left_over(AlignmentMethod::poses, kTilted, 1.0), 1e-9);
  EXPECT_LT(left_over(AlignmentMethod::similarity, kTilted, kScale), 1e-9);
  EXPECT_LT(left_over(AlignmentMethod::scale, {}, kScale), 1e-9);
  EXPECT_GT(left_over(AlignmentMethod::yaw_translation, kTilted, 1.0), 0.1)
      << "roll and pitch are the estimate's own";
}

TEST(Alignment, LeastSquaresCannotBeImprovedByASmallMotion) {
  const Trajectory estimate = winding_walk(60);
  Trajectory reference = moved(estimate, kTurned);
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double s = static_cast<double>(i);
    reference[i].pose.translation +=
        0.2 * Eigen::Vector3d(std::sin(7.0 * s), std::cos(5.0 * s), std::sin(3.0 * s));
  }
  const auto cost = [&](const Trajectory& trajectory) {
    double sum = 0.0;
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
      sum += (trajectory[i].pose.translation - reference[i].pose.translation).squaredNorm();
    }
    return sum;
  };
  for (const AlignmentMethod method :
       {AlignmentMethod::yaw_translation, AlignmentMethod::rigid, AlignmentMethod::similarity}) {
    const Trajectory best = aligned(estimate, find_alignment({reference, estimate}, method));
    for (int axis = 0; axis < 6; ++axis) {
      const bool roll_or_pitch = axis == 3 || axis == 4;
      if (method == AlignmentMethod::yaw_translation && roll_or_pitch) continue;
      for (const double step : {-1e-3, 1e-3}) {
        Twist twist = Twist::Zero();
        twist[axis] = step;
        EXPECT_GT(cost(moved(best, se3_exp(twist))), cost(best)) << "axis " << axis;
      }
    }
  }
}

TEST(Alignment, OrientationsDecideTheTurnAboutAStraightWay) {
  Trajectory estimate = straight_walk(200, 0.5);
  Trajectory reference = moved(estimate, kTilted);
  for (std::size_t i = 0; i < reference.size(); ++i) {  // both are a little off the line
    const double s = static_cast<double>(i);
    reference[i].pose.translation +=
        1e-3 * Eigen::Vector3d(std::sin(7.0 * s), std::cos(5.0 * s), std::sin(3.0 * s));
    estimate[i].pose.translation +=
        1e-3 * Eigen::Vector3d(std::cos(4.0 * s), std::sin(6.0 * s), std::cos(9.0 * s));
  }
  const auto left_over_deg = [&](AlignmentMethod method) {
    const Trajectory result = aligned(estimate, find_alignment({reference, estimate}, method));
    return result[100].pose.rotation.angularDistance(reference[100].pose.rotation) * 57.2958;
  };
  EXPECT_GT(left_over_deg(AlignmentMethod::rigid), 1.0);
  EXPECT_LT(left_over_deg(AlignmentMethod::poses), 0.01);
  EXPECT_TRUE(leaves_turn_open({reference, estimate}, AlignmentMethod::rigid));
  EXPECT_FALSE(leaves_turn_open({reference, estimate}, AlignmentMethod::poses));
  const Trajectory winding = winding_walk(60);
  EXPECT_FALSE(leaves_turn_open({winding, winding}, AlignmentMethod::rigid));
}

/// What a still robot is off its place is as wide one way as another, so that ratios tell nothing.
TEST(Alignment, PositionsOfAStayOrNoWiderThanTheirErrorsLeaveTheTurnOpen) {
  const auto shaken = [](Trajectory trajectory, double by) {
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
      const double s = static_cast<double>(i);
      trajectory[i].pose.translation +=
          by * Eigen::Vector3d(std::cos(4.0 * s), std::sin(6.0 * s), std::cos(9.0 * s));
    }
    return trajectory;
  };
  const Trajectory stay = straight_walk(100, 1e-9);
  EXPECT_TRUE(leaves_turn_open({stay, shaken(stay, 1e-3)}, AlignmentMethod::rigid));
  EXPECT_TRUE(leaves_turn_open({stay, stay}, AlignmentMethod::rigid)) << "no alignment at all";
  EXPECT_FALSE(leaves_turn_open({stay, shaken(stay, 1e-3)}, AlignmentMethod::poses));
  const Trajectory winding = winding_walk(60);  // two metres wide
  EXPECT_FALSE(leaves_turn_open({winding, shaken(winding, 0.1)}, AlignmentMethod::rigid));
  EXPECT_TRUE(leaves_turn_open({winding, shaken(winding, 3.0)}, AlignmentMethod::rigid));
  EXPECT_FALSE(leaves_turn_open({moved(winding, kTilted, kScale), shaken(winding, 0.1)},
                                AlignmentMethod::similarity));
}

TEST(Alignment, FirstPosesAloneDecideIfAskedTo) {
  const Trajectory estimate = winding_walk(60);
  Trajectory reference = moved(estimate, kTilted);
  for (std::size_t i = 30; i < 60; ++i) reference[i].pose.translation.x() += 5.0;
  const TrajectoryAlignment found =
      find_alignment({reference, estimate}, AlignmentMethod::rigid, 30);
  const Trajectory result = aligned(estimate, found);
  EXPECT_LT((result[10].pose.translation - reference[10].pose.translation).norm(), 1e-9);
  EXPECT_NEAR((result[40].pose.translation - reference[40].pose.translation).norm(), 5.0, 1e-9);
  EXPECT_NO_THROW((void)find_alignment({reference, estimate}, AlignmentMethod::rigid, 1'000'000));
}

TEST(Alignment, NeverMirrors) {
  const Trajectory estimate = winding_walk(60);
  Trajectory mirrored = estimate;
  for (StampedPose& pose : mirrored) pose.pose.translation.x() *= -1.0;
  const TrajectoryAlignment found = find_alignment({mirrored, estimate}, AlignmentMethod::rigid);
  EXPECT_NEAR(found.pose.rotation.toRotationMatrix().determinant(), 1.0, 1e-12);
}

TEST(Alignment, WhatThePositionsDoNotDetermineIsAnError) {
  const Trajectory line = straight_walk(10, 0.5);
  const Trajectory point(10, stamped(0.0, {1.0, 2.0, 3.0}));
  EXPECT_THROW((void)find_alignment({line, line}, AlignmentMethod::rigid), std::runtime_error);
  EXPECT_THROW((void)find_alignment({line, line}, AlignmentMethod::similarity), std::runtime_error);
  EXPECT_NO_THROW((void)find_alignment({line, line}, AlignmentMethod::yaw_translation));
  EXPECT_NO_THROW((void)find_alignment({line, line}, AlignmentMethod::poses));
  EXPECT_NO_THROW((void)find_alignment({point, point}, AlignmentMethod::poses));
  EXPECT_THROW((void)find_alignment({point, point}, AlignmentMethod::yaw_translation),
               std::runtime_error);
  EXPECT_NO_THROW((void)find_alignment({point, point}, AlignmentMethod::origin));
  try {
    (void)find_alignment({line, line}, AlignmentMethod::rigid);
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("--align poses"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace surefoot::evaluation
