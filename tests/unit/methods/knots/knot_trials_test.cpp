// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_trials.hpp"

#include <gtest/gtest.h>

#include "unit/methods/knots/swaying_scan.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scan of the test support

class KnotTrialsTest : public testing::Test {
 protected:
  Config::Knots config_ = Config().knots;
  VelocityModel model_{config_};
  Workers alone_{1};
  KnotWindow truth_ = window_along(swaying);
  KnotPrior prior_ = prior_at(truth_, 0.01);
  KnotProblem problem_{true_map(), prior_, model_, config_, alone_, kNobody};
  KnotTrials trials_{scan_points(), config_};
};

TEST_F(KnotTrialsTest, AStartNearTheTruthLeadsToIt) {
  KnotWindow start = truth_;
  for (std::size_t k = 2; k < start.knots.size(); ++k) {
    start.knots[k].translation += Eigen::Vector3d(0.2, -0.2, 0.1);
  }
  const KnotRegistration found = trials_.run(problem_, start, usual_annealing(config_));
  ASSERT_TRUE(found.solved);
  const KnotError error = error_of(found.window);
  EXPECT_LT(error.translation, 0.05);  // by a part of the points; 0.02 by all of them
  EXPECT_LT(error.rotation_deg, 1.0);
}

TEST_F(KnotTrialsTest, EndsSoonAfterTheKernelHasNarrowed) {
  Config::Knots never = config_;
  never.convergence = 1e-12;
  const KnotProblem problem{true_map(), prior_, model_, never, alone_, kNobody};
  const KnotTrials trials(scan_points(), never);
  const KnotRegistration found = trials.run(problem, truth_, usual_annealing(never));
  EXPECT_FALSE(found.converged);
  // From 1.5 m to 0.1 m by 0.8 each takes 13, and 6 more.
  EXPECT_LE(found.iterations, 19);
  EXPECT_GE(found.settling, 6);
}

TEST_F(KnotTrialsTest, HowMuchDisagreesIsSeenByOneLook) {
  const double at_truth = trials_.disagreement_at(truth_, problem_);
  const KnotRegistration all = register_from(truth_, prior_);
  EXPECT_NEAR(at_truth, all.disagreement(config_.unseen_weight), 0.05);  // every so many-th point
  KnotWindow beside = truth_;
  for (Pose& knot : beside.knots) knot.translation.z() += 0.5;
  EXPECT_GT(trials_.disagreement_at(beside, problem_), 1.5 * at_truth);
}

// Against the last scan and the velocity model.
TEST_F(KnotTrialsTest, SomePointsWeighAsMuchAsAll) {
  const Annealing usual = usual_annealing(config_);
  const double some = trials_.run(problem_, truth_, usual).rigid.H.trace();
  EXPECT_NEAR(some / register_from(truth_, prior_).rigid.H.trace(), 1.0, 0.2);
}

TEST_F(KnotTrialsTest, EndsUnsolvedWhereItIsToldTo) {
  int asked = 0;
  const auto never_mind = [&](const KnotRegistration&, double) { return ++asked == 2; };
  EXPECT_FALSE(trials_.run(problem_, truth_, usual_annealing(config_), never_mind).solved);
  EXPECT_EQ(asked, 2);
}

}  // namespace
}  // namespace surefoot
