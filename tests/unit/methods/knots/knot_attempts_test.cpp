// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_attempts.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "unit/methods/knots/swaying_scan.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scan of the test support

KnotRegistration attempts_from(const KnotWindow& start, const KnotPrior& prior,
                               const UsualFit& usual, int* searches = nullptr,
                               const VelocityModel& model = VelocityModel(Config().knots),
                               int threads = 1) {
  const Config::Knots config = Config().knots;
  const Workers workers(threads);
  const StepObserver count = [&](Step step) {
    if (searches != nullptr && step == Step::search) ++*searches;
  };
  KnotPoints points = scan_points();
  return register_in_attempts(points, {true_map(), prior, model, config, workers, count}, start,
                              usual);
}

TEST(KnotAttempts, AUsualScanNeedsOne) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  const KnotRegistration one = register_from(truth, prior);
  UsualFit usual;
  usual.learn(one, 1.0, Config().knots);
  int searches = 0;
  const KnotRegistration found = attempts_from(truth, prior, usual, &searches);
  EXPECT_EQ(searches, one.iterations);
  EXPECT_EQ(found.misfit, one.misfit);
}

/// As it is, but that the sensor rolls, pitches and turns by so much within the scan.
KnotWindow turned(const KnotWindow& window, const Eigen::Vector3d& degrees) {
  KnotWindow start = window;
  for (std::size_t k = 2; k < start.knots.size(); ++k) {
    const double share = static_cast<double>(k - 1) / kSegments;
    start.knots[k].rotation =
        start.knots[k].rotation * from_roll_pitch_yaw(share * kDegree * degrees);
  }
  return start;
}

// Six swings and six turns begin with a kernel of 0.2 m, which narrows to 0.1 in two to four
// iterations, two swings with 0.5 m, in four to eight, the wide one with 3 m, in nine to sixteen.
// Where all lead to the same place, that is seen then, or a step before. Before these, four ends
// are begun anew as the swings are, after a look at what is to be beaten.
constexpr int kLeastSearches = 12 * 2 + 2 * 4 + 9 + 4 * 2 + 1;
constexpr int kMostSearches = 12 * 3 + 2 * 8 + 20 + 4 * 3 + 1;

TEST(KnotAttempts, ASuspiciousOneIsTriedFromOtherMotionsAndTheBestIsKept) {
  // A map that is usually met better, and a prediction that pitches by 20 deg within the scan.
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  UsualFit usual;
  usual.learn(register_from(truth, prior), 1.0, Config().knots);
  usual.disagreement *= 0.5;
  const KnotWindow start = turned(truth, {0.0, 20.0, 0.0});
  int searches = 0;
  const KnotRegistration found = attempts_from(start, prior, usual, &searches);
  ASSERT_TRUE(found.solved);
  EXPECT_GT(searches, kLeastSearches);
  EXPECT_LE(found.misfit, register_from(start, prior).misfit);
  const KnotError error = error_of(found.window);
  std::printf("from a pitch of 20 deg: %.4f m, %.3f deg, misfit %.3f\n", error.translation,
              error.rotation_deg, found.misfit);
  EXPECT_LT(error.translation, 0.02);  // as from the truth
  EXPECT_LT(error.rotation_deg, 0.7);
}

TEST(KnotAttempts, AreTheSameBitsOnTwoThreads) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  UsualFit usual;
  usual.learn(register_from(truth, prior), 1.0, Config().knots);
  usual.disagreement *= 0.5;
  const VelocityModel model(Config().knots);
  int others_taken = 0;
  for (const Eigen::Vector3d& degrees : {Eigen::Vector3d(0.0, 20.0, 0.0),
                                         {0.0, 40.0, 0.0},
                                         {40.0, 0.0, 0.0},
                                         {0.0, 0.0, 60.0},
                                         {0.0, 0.0, 90.0}}) {
    const KnotWindow start = turned(truth, degrees);
    const KnotRegistration one = attempts_from(start, prior, usual, nullptr, model, 1);
    const KnotRegistration two = attempts_from(start, prior, usual, nullptr, model, 2);
    others_taken += one.misfit != register_from(start, prior).misfit ? 1 : 0;
    EXPECT_EQ(one.misfit, two.misfit);
    EXPECT_EQ(one.window.knots.back().translation, two.window.knots.back().translation);
  }
  EXPECT_GT(others_taken, 0);
}

TEST(KnotAttempts, WhereTheyLeadToTheSamePlaceTheyCostLittle) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  const KnotRegistration one = register_from(truth, prior);
  ASSERT_TRUE(one.converged);
  ASSERT_LT(runs_away_from(one.disagreements, Config().knots.suspicious), one.disagreements.size());
  UsualFit usual;
  usual.learn(one, 1.0, Config().knots);
  usual.disagreement *= 0.5;
  int searches = 0;
  const KnotRegistration found = attempts_from(truth, prior, usual, &searches);
  EXPECT_EQ(found.misfit, one.misfit);
  EXPECT_EQ(found.window.knots.back().translation, one.window.knots.back().translation);
  const int others = searches - one.iterations - 1;  // and one look at what is to be beaten
  EXPECT_GE(others, kLeastSearches);
  EXPECT_LE(others, kMostSearches);
}

TEST(KnotAttempts, WhatIsFarWorseIsTriedWithALooserModel) {
  const KnotWindow truth = window_along(swaying);
  const KnotPrior prior = prior_at(truth, 0.01);
  UsualFit usual;
  usual.learn(register_from(truth, prior), 1.0, Config().knots);
  usual.disagreement *= 0.5;  // so that it is suspicious, but not wrong
  int searches = 0;
  (void)attempts_from(truth, prior, usual, &searches);
  usual.misfit_of_seen = -1.0;  // wrong, whatever is found
  int searches_with = 0;
  (void)attempts_from(truth, prior, usual, &searches_with);
  // Two, patiently: half as fast from 3 m to 0.1, or as fast as usual where nothing moves.
  EXPECT_GE(searches_with - searches, 2 * 15);
  EXPECT_LE(searches_with - searches, 2 * 37);
}

/// The hall of true_map(), where nothing is a plane or a pole.
const SurfelMap& map_of_clouds() {
  static const SurfelMap map = [] {
    Config::Knots config = Config().knots;
    config.flatness = config.slenderness = 1e-9;
    return map_of_walk(config);
  }();
  return map;
}

/// Of a scan whose last one says, to 7 mm, that it begins so far behind, in a map that so many
/// scans were registered in: how far it is off at its end [m].
double end_of_who_is(double behind, int scans) {
  const Config::Knots config = Config().knots;
  const KnotWindow truth = window_along(swaying);
  KnotWindow start = truth;
  for (Pose& knot : start.knots) knot.translation.x() -= behind;
  const KnotPrior prior = prior_at(start, 0.007);
  const VelocityModel model(config);
  const Workers workers(1);
  KnotPoints points = scan_points();
  const UsualFit usual{.misfit = 0.0, .disagreement = 0.0, .misfit_of_seen = 0.0, .scans = scans};
  const KnotRegistration found = register_in_attempts(
      points, {map_of_clouds(), prior, model, config, workers, kNobody}, start, usual);
  return difference(found.window.knots.back(), truth.knots.back()).head<3>().norm();
}

// As on a hilltop, where rings go with who begins to walk, and the scans before say that he stands.
TEST(KnotAttempts, WhereNothingIsPlaneTheLastScanIsNearlyForgotten) {
  EXPECT_GT(end_of_who_is(0.7, 2), 0.2);  // measured: 0.32, where it is not
  EXPECT_LT(end_of_who_is(0.7, 3), 0.1);  // measured: 0.06
  // Where it ends at nearly the same place, it is not taken.
  EXPECT_EQ(end_of_who_is(0.4, 3), end_of_who_is(0.4, 2));
}

// Segments' disagreements as they were seen of a runner in a forest, whose end ran away.
TEST(KnotAttempts, AnEndRunsAwayFromWhereItsSegmentsFitWorse) {
  using Segments = std::vector<double>;
  const auto from = [](const Segments& segments) { return runs_away_from(segments, 1.25); };
  EXPECT_EQ(from({0.11, 0.15, 0.13, 0.12, 0.32, 0.38, 0.38, 0.47}), 4U);
  EXPECT_EQ(from({0.10, 0.17, 0.16, 0.12, 0.10, 0.33, 0.43, 0.47}), 5U);
  EXPECT_EQ(from({0.10, 0.12, 0.11, 0.07, 0.08, 0.12, 0.36, 0.43}), 6U);
  EXPECT_EQ(from({0.09, 0.11, 0.13, 0.10, 0.08, 0.08, 0.18, 0.43}), 7U);
  EXPECT_EQ(from({0.37, 0.13, 0.11, 0.09, 0.09, 0.14, 0.44, 0.49}), 6U);  // the begin, too
  // None: it begins badly, fits alike, or hardly worse.
  EXPECT_EQ(from({0.39, 0.13, 0.11, 0.09, 0.09, 0.08, 0.09, 0.08}), 8U);
  EXPECT_EQ(from(Segments(8, 0.1)), 8U);
  EXPECT_EQ(from({0.10, 0.10, 0.10, 0.10, 0.12, 0.12, 0.12, 0.12}), 8U);
  EXPECT_EQ(from({0.10, 0.10, 0.10, 0.10, 0.13, 0.13, 0.13, 0.13}), 4U);
  EXPECT_EQ(from({0.3}), 1U);
  EXPECT_EQ(from({}), 0U);
}

/// 1.25 times the usual on planes and poles; in clouds all that is more than usual.
TEST(KnotAttempts, InCloudsLittleIsSuspicious) {
  const Config::Knots config = Config().knots;
  KnotRegistration found;
  found.converged = true;
  found.matches = 1000;
  found.unseen = 0.0;
  UsualFit usual;
  usual.misfit = usual.disagreement = 0.4;
  const auto suspicious = [&](double misfit, int clouds) {
    found.misfit = misfit;
    found.clouds = clouds;
    return is_suspicious(found, usual, config);
  };
  EXPECT_FALSE(suspicious(0.49, 0));
  EXPECT_TRUE(suspicious(0.51, 0));
  EXPECT_FALSE(suspicious(0.49, 290));
  EXPECT_FALSE(suspicious(0.44, 400));  // half way
  EXPECT_TRUE(suspicious(0.46, 400));
  EXPECT_TRUE(suspicious(0.41, 510));
  EXPECT_FALSE(suspicious(0.39, 700));
  found.converged = false;
  EXPECT_TRUE(is_suspicious(found, usual, config));
}

TEST(KnotAttempts, TheUsualFadesAndWhatIsUnseenCountsLittle) {
  const Config::Knots config = Config().knots;
  KnotRegistration found;
  found.misfit = 0.5;
  found.unseen = 0.4;  // so that 0.1 are of points that the map has seen
  UsualFit usual;
  usual.learn(found, 1.0, config);
  EXPECT_DOUBLE_EQ(usual.misfit, 0.5);
  EXPECT_NEAR(usual.disagreement, 0.1 + 0.2 * 0.4, 1e-12);
  EXPECT_NEAR(usual.misfit_of_seen, 0.1 / 0.6, 1e-12);
  EXPECT_NEAR(usual.most_misfit_of_seen(config), 2.0 * 0.1 / 0.6 + 0.15, 1e-12);
  found.misfit = 0.4;
  usual.learn(found, 0.1, config);
  EXPECT_NEAR(usual.misfit, 0.49, 1e-12);
}

}  // namespace
}  // namespace surefoot
