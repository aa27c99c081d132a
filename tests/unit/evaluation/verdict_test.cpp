// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/verdict.hpp"

#include <gtest/gtest.h>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

RunVerdict verdict_of(const Trajectory& reference, const Trajectory& estimate,
                      const EvaluationOptions& options = {}) {
  return judge(reference, estimate, evaluate("e", reference, estimate, options), options);
}

TEST(Verdict, AWholeRunIsWhole) {
  const Trajectory walk = test::winding_walk(400);
  const RunVerdict verdict = verdict_of(walk, walk);
  EXPECT_EQ(verdict.outcome, Outcome::whole);
  EXPECT_EQ(verdict.text, "");
}

TEST(Verdict, ARunThatEndsEarlyHasStoppedHoweverSmallItsError) {
  const Trajectory walk = test::winding_walk(401);
  const Trajectory part(walk.begin(), walk.begin() + 165);
  const RunVerdict verdict = verdict_of(walk, part);
  EXPECT_EQ(verdict.outcome, Outcome::stopped);
  EXPECT_EQ(verdict.text, "stopped at 41 %");
}

TEST(Verdict, TheEstimatesClockIsShifted) {
  const Trajectory walk = test::winding_walk(401);
  Trajectory late = walk;
  for (StampedPose& pose : late) pose.stamp_ns -= 20'000'000'000;
  EvaluationOptions options;
  options.association.offset = 20.0;
  EXPECT_EQ(verdict_of(walk, late, options).outcome, Outcome::whole);
  late.resize(165);
  EXPECT_EQ(verdict_of(walk, late, options).text, "stopped at 41 %");
}

TEST(Verdict, WhatCoversAsMuchAsIsAskedForIsWhole) {
  const Trajectory walk = test::winding_walk(401);
  const Trajectory half(walk.begin(), walk.begin() + 201);
  const Evaluation evaluation = evaluate("e", walk, half, {});
  ASSERT_EQ(evaluation.coverage, 0.5);
  EXPECT_EQ(judge(walk, half, evaluation, {}, {.full_coverage = 0.5}).outcome, Outcome::whole);
  EXPECT_EQ(judge(walk, half, evaluation, {}, {.full_coverage = 0.51}).outcome, Outcome::stopped);
}

TEST(Verdict, HolesAreToldAsCoverage) {
  const Trajectory walk = test::winding_walk(401);
  Trajectory holed(walk.begin(), walk.begin() + 101);
  holed.insert(holed.end(), walk.begin() + 201, walk.end());
  const RunVerdict verdict = verdict_of(walk, holed);
  EXPECT_EQ(verdict.outcome, Outcome::partial);
  EXPECT_EQ(verdict.text, "covers only 74 %");
}

TEST(Verdict, NoCloserThanStandingStillIsDiverged) {
  const Trajectory walk = test::winding_walk(400);
  Trajectory away = walk;
  for (std::size_t i = 0; i < away.size(); ++i) {
    away[i].pose.translation += 1e-3 * static_cast<double>(i * i) * Eigen::Vector3d::UnitY();
  }
  EXPECT_EQ(verdict_of(walk, away).outcome, Outcome::diverged);
  EXPECT_EQ(verdict_of(walk, away).text, "diverged");
  // Nearly standing: as far off as standing, though it never went far.
  Trajectory nearly = walk;
  for (StampedPose& pose : nearly) pose.pose.translation *= 0.01;
  EXPECT_EQ(verdict_of(walk, nearly).outcome, Outcome::diverged);
}

TEST(Verdict, AFewCentimetresAreNoDivergenceOfARobotThatStands) {
  Trajectory standing = test::winding_walk(100), wobbling = standing;
  for (std::size_t i = 0; i < standing.size(); ++i) {
    standing[i].pose.translation *= 1e-3;
    wobbling[i].pose.translation *= 3e-3;
  }
  EXPECT_EQ(verdict_of(standing, wobbling).outcome, Outcome::whole);
}

// The best that a single place can do is the mean of the reference's positions.
TEST(Verdict, StandingErrorIsTheSpreadOfTheReference) {
  const Trajectory square = {test::stamped(0, {0, 0, 0}), test::stamped(1, {2, 0, 0}),
                             test::stamped(2, {2, 2, 0}), test::stamped(3, {0, 2, 0})};
  EXPECT_NEAR(standing_error(square), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(standing_error({}), 0.0);
}

TEST(Verdict, EmptyTrajectoriesAreRefused) {
  EXPECT_THROW((void)judge({}, test::winding_walk(3), {}, {}), std::invalid_argument);
  EXPECT_THROW((void)judge(test::winding_walk(3), {}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::evaluation
