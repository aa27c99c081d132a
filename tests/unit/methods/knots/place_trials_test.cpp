// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/place_trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/so3.hpp"
#include "support/synthetic_run.hpp"
#include "unit/methods/knots/swaying_scan.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scan and the map of the test support

class PlaceTrialsTest : public testing::Test {
 protected:
  PlaceTrialsTest() {
    for (std::uint32_t i = 0; i < scan_.points.size(); i += 3) chosen_.push_back(i);
  }
  [[nodiscard]] KnotProblem problem(const Workers& workers) const {
    return {true_map(), prior_, model_, config_, workers, kNobody};
  }

  Config::Knots config_ = Config().knots;
  VelocityModel model_{config_};
  PreparedScan scan_ =
      preprocess(take_scan(furnished_hall(), swaying, kScanStart, {}), Config().preprocess);
  std::vector<std::uint32_t> chosen_;
  KnotWindow truth_ = window_along(swaying);
  KnotPrior prior_ = prior_at(truth_, 0.01);
  Pose middle_ = swaying(kScanStart + 0.05);
  Pose begin_ = swaying(kScanStart);
  Pose beside_{begin_.rotation * so3_exp({0.0, 0.0, 0.2}),
               begin_.translation + Eigen::Vector3d(0.5, -0.4, 0.1)};
  Pose elsewhere_{begin_.rotation * so3_exp({0.0, 0.0, 1.8}),
                  begin_.translation + Eigen::Vector3d(3.0, 1.0, 0.0)};
};

TEST_F(PlaceTrialsTest, ThePlaceWhereItWasTakenAgreesBest) {
  const Workers workers(1);
  const KnotProblem problem = this->problem(workers);
  const PlaceTrials trials(scan_, chosen_, problem);
  const auto ends = trials.from({{elsewhere_, Twist::Zero()}, {beside_, Twist::Zero()}});
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_LT((ends[0].pose.translation - middle_.translation).norm(), 0.1);
  EXPECT_LT(ends[0].pose.rotation.angularDistance(middle_.rotation), 2.0 * kDegree);
  EXPECT_GT(ends[1].disagreement, 1.5 * ends[0].disagreement);
  // What it began from is kept: a registration goes on from there.
  EXPECT_EQ(ends[0].begin.prior.means[1].translation, beside_.translation);
  EXPECT_EQ(ends[0].predicted.knots[1].translation, beside_.translation);
}

TEST_F(PlaceTrialsTest, OfTwoThatEndAtOnePlaceOneIsTold) {
  const Workers workers(1);
  const KnotProblem problem = this->problem(workers);
  const PlaceTrials trials(scan_, chosen_, problem);
  const Pose near{beside_.rotation, beside_.translation - Eigen::Vector3d(0.3, 0.0, 0.1)};
  double least = 1.0;
  for (const Pose& place : {beside_, near}) {
    least = std::min(least, trials.from({{place, Twist::Zero()}}).at(0).disagreement);
  }
  const auto ends = trials.from({{beside_, Twist::Zero()}, {near, Twist::Zero()}});
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(ends[0].disagreement, least, 0.01);
}

// From far away the first trial has not come to its end yet.
TEST_F(PlaceTrialsTest, TheBestGoesOnceMoreFromWhereItEnded) {
  const Workers workers(1);
  const KnotProblem problem = this->problem(workers);
  const PlaceTrials trials(scan_, chosen_, problem);
  int better = 0;
  for (const double turn : {-0.4, -0.2, 0.2, 0.4}) {
    const Pose place{begin_.rotation * so3_exp({0.0, 0.0, turn}),
                     begin_.translation + Eigen::Vector3d(1.0, 2.0 * turn, 0.2)};
    const KnotEnd begin = begin_at(place, scan_, config_);
    const KnotWindow start =
        predict_knots(scan_, begin, model_, config_).at_velocity(Twist::Zero());
    const KnotTrials by_hand(sort_points(scan_, chosen_, start), config_);
    const KnotProblem there{true_map(), begin.prior, model_, config_, workers, kNobody};
    const double once = by_hand.disagreement(by_hand.run(there, start, usual_annealing(config_)));
    const double twice = trials.from({{place, Twist::Zero()}}).at(0).disagreement;
    EXPECT_LE(twice, once) << turn;
    if (twice < once) ++better;
  }
  EXPECT_GE(better, 1);
}

TEST_F(PlaceTrialsTest, AMotionIsWhatItBeginsWith) {
  const Workers workers(1);
  const KnotProblem problem = this->problem(workers);
  Twist velocity = Twist::Zero();
  velocity << 1.0, 0.0, 0.0, 0.0, 0.0, 0.5;
  const auto ends = PlaceTrials(scan_, chosen_, problem).from({{beside_, velocity}});
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_LT((ends[0].predicted.mean_velocity() - velocity).norm(), 1e-9);
}

TEST_F(PlaceTrialsTest, WhatIsGoingToDisagreeFarMoreIsLeftOut) {
  const Workers workers(1);
  const KnotProblem problem = this->problem(workers);
  const PlaceTrials trials(scan_, chosen_, problem);
  const double least = trials.disagreement_at(truth_);
  const auto ends = trials.from({{elsewhere_, Twist::Zero()}, {beside_, Twist::Zero()}}, least);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_LT((ends[0].pose.translation - middle_.translation).norm(), 0.1);
  EXPECT_NEAR(ends[0].disagreement, least, 0.05);
  EXPECT_TRUE(trials.from({}).empty());
}

TEST_F(PlaceTrialsTest, ThreadsDoNotChangeABit) {
  const std::vector<PlaceStart> starts = {{elsewhere_, Twist::Zero()}, {beside_, Twist::Zero()}};
  const Workers one(1), three(3);
  const KnotProblem alone = problem(one), together = problem(three);
  const auto a = PlaceTrials(scan_, chosen_, alone).from(starts);
  const auto b = PlaceTrials(scan_, chosen_, together).from(starts);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].disagreement, b[i].disagreement);
    EXPECT_EQ(a[i].unseen, b[i].unseen);
    EXPECT_EQ(a[i].pose.matrix(), b[i].pose.matrix());
  }
}

}  // namespace
}  // namespace surefoot
