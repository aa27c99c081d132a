// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/evaluate.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::stamped;
using test::straight_walk;

std::vector<std::string> names_of(const std::vector<NamedStatistics>& errors) {
  std::vector<std::string> names;
  for (const NamedStatistics& named : errors) names.push_back(named.name);
  return names;
}

/// Straight ahead at a metre a second, by a clock that is `late` seconds behind.
Trajectory walk_between(double begin, double end, double step, double late) {
  Trajectory walk;
  for (int i = 0; begin + step * i < end + 1e-6; ++i) {
    walk.push_back(stamped(begin + step * i - late, {begin + step * i, 0.0, 0.0}));
  }
  return walk;
}

// The clocks are 20 s apart.
TEST(Evaluate, CountsThePairsThatThereCouldBeByTheReferencesClock) {
  const EvaluationOptions options{.association = {.offset = 20.0},
                                  .alignment = AlignmentMethod::none};
  const Trajectory reference = walk_between(0.0, 10.0, 0.1, 0.0);
  const auto most = [&](const Trajectory& estimate) {
    return evaluate("e", reference, estimate, options).most_pairs;
  };
  EXPECT_EQ(most(walk_between(-2.0, 13.0, 0.2, 20.0)), 51U) << "longer than the reference";
  EXPECT_EQ(most(walk_between(2.0, 8.0, 0.05, 20.0)), 61U) << "within it, and denser";
}

TEST(Evaluate, OfPositionsAloneSaysNothingOfRotations) {
  const Trajectory reference = straight_walk(41, 1.0);
  Trajectory estimate = reference;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    estimate[i].pose.translation.z() += 0.01 * static_cast<double>(i);
  }
  EvaluationOptions options{.alignment = AlignmentMethod::none, .positions_only = true};
  const Evaluation evaluation = evaluate("prism", reference, estimate, options);
  EXPECT_EQ(names_of(evaluation.absolute),
            (std::vector<std::string>{"ape_translation", "ape_horizontal", "ape_vertical"}));
  EXPECT_EQ(names_of(evaluation.relative),
            (std::vector<std::string>{"rpe_distance", "rpe_distance_percent"}));
  EXPECT_TRUE(evaluation.segments.by_length.empty());
  EXPECT_NEAR(evaluation.drift.vertical, 0.4, 1e-9) << "the estimate ends too high";
  EXPECT_NEAR(evaluation.drift.path_length, 40.0, 1e-9);
  for (const AlignmentMethod method : {AlignmentMethod::origin, AlignmentMethod::poses}) {
    options.alignment = method;
    EXPECT_THROW((void)evaluate("prism", reference, estimate, options), std::runtime_error);
  }
}

// The estimate's strides are twice as long.
TEST(Evaluate, StretchesAreMeasuredAlongTheTrajectoryThatIsAskedFor) {
  EvaluationOptions options{.alignment = AlignmentMethod::none,
                            .stretches = {.delta = 10.0, .unit = DeltaUnit::metres}};
  const auto error = [&] {
    const Evaluation evaluation =
        evaluate("e", straight_walk(101, 1.0), straight_walk(101, 2.0), options);
    return find_statistics(evaluation, "rpe_translation")->mean;
  };
  EXPECT_NEAR(error(), 5.0, 1e-9);
  options.stretches_from_reference = true;
  EXPECT_NEAR(error(), 10.0, 1e-9);
}

TEST(Evaluate, SegmentsAreAsLongAsTold) {
  const Trajectory walk = straight_walk(101, 1.0);
  const EvaluationOptions options{.alignment = AlignmentMethod::none, .segment_lengths = {7.0}};
  const Evaluation evaluation = evaluate("e", walk, walk, options);
  ASSERT_EQ(evaluation.segments.by_length.size(), 1U);
  EXPECT_EQ(evaluation.segments.by_length[0].length, 7.0);
}

TEST(Evaluate, WhereTheReferenceStandsThereIsNoPercentage) {
  const Evaluation evaluation = evaluate("e", straight_walk(20, 0.0), straight_walk(20, 0.1),
                                         {.alignment = AlignmentMethod::none});
  EXPECT_NE(find_statistics(evaluation, "rpe_distance"), nullptr);
  EXPECT_EQ(find_statistics(evaluation, "rpe_distance_percent"), nullptr);
}

}  // namespace
}  // namespace surefoot::evaluation
