// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/rpe.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <stdexcept>

#include "walks.hpp"

namespace surefoot::evaluation {
namespace {

using test::stamped;
using test::straight_walk;
using test::winding_walk;

std::vector<std::pair<std::size_t, std::size_t>> plain(const std::vector<IndexPair>& pairs) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const IndexPair& pair : pairs) result.emplace_back(pair.from, pair.to);
  return result;
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(Stretches, OverFrames) {
  const Trajectory walk = straight_walk(7, 1.0);
  EXPECT_EQ(plain(find_pairs(walk, {.delta = 3.0})), (Pairs{{0, 3}, {3, 6}}));
  EXPECT_EQ(plain(find_pairs(walk, {.delta = 3.0, .all_pairs = true})),
            (Pairs{{0, 3}, {1, 4}, {2, 5}, {3, 6}}));
  EXPECT_TRUE(find_pairs(walk, {.delta = 7.0}).empty());
  EXPECT_TRUE(find_pairs(walk, {.delta = 7.0, .all_pairs = true, .tolerance = 0.5}).empty());
}

TEST(Stretches, OverMetresStartWhereThePathFirstReachesDelta) {
  const Trajectory walk = straight_walk(10, 0.4);
  EXPECT_EQ(plain(find_pairs(walk, {.delta = 1.0, .unit = DeltaUnit::metres})),
            (Pairs{{3, 6}, {6, 9}}));
}

TEST(Stretches, OverMetresAllPairsEndNearestToDelta) {
  const Trajectory walk = straight_walk(6, 0.45);
  const PairOptions options{
      .delta = 1.0, .unit = DeltaUnit::metres, .all_pairs = true, .tolerance = 0.11};
  EXPECT_EQ(plain(find_pairs(walk, options)), (Pairs{{0, 2}, {1, 3}, {2, 4}, {3, 5}}));
  const PairOptions strict{
      .delta = 1.0, .unit = DeltaUnit::metres, .all_pairs = true, .tolerance = 0.05};
  EXPECT_TRUE(find_pairs(walk, strict).empty());
}

TEST(Stretches, AllPairsWhileStandingEndAtTheFirstPoseThere) {
  Trajectory walk;
  for (const double x : {0.0, 1.0, 1.0, 1.0, 1.0, 2.0}) {
    walk.push_back(stamped(static_cast<double>(walk.size()), {x, 0.0, 0.0}));
  }
  const PairOptions options{.delta = 1.02, .unit = DeltaUnit::metres, .all_pairs = true};
  EXPECT_EQ(plain(find_pairs(walk, options)), (Pairs{{0, 1}, {1, 5}, {2, 5}, {3, 5}, {4, 5}}));
}

TEST(Stretches, OverSeconds) {
  Trajectory walk;
  for (const double t : {0.0, 0.4, 0.8, 1.2, 1.6, 2.0, 2.4}) {
    walk.push_back(stamped(t, {0.0, 0.0, 0.0}));
  }
  EXPECT_EQ(plain(find_pairs(walk, {.delta = 1.0, .unit = DeltaUnit::seconds})),
            (Pairs{{0, 3}, {3, 6}}));
  const PairOptions all{
      .delta = 0.8, .unit = DeltaUnit::seconds, .all_pairs = true, .tolerance = 0.01};
  EXPECT_EQ(find_pairs(walk, all).size(), 5U);
}

// Ten steps of 0.1 s, summed as doubles, are less than a second.
TEST(Stretches, OverSecondsTakeNoPoseTooMany) {
  const Trajectory walk = winding_walk(61);
  PairOptions options{.delta = 1.0, .unit = DeltaUnit::seconds};
  EXPECT_EQ(plain(find_pairs(walk, options)),
            (Pairs{{0, 10}, {10, 20}, {20, 30}, {30, 40}, {40, 50}, {50, 60}}));
  options.all_pairs = true;
  options.tolerance = 0.0;
  EXPECT_EQ(find_pairs(walk, options).size(), 51U);
}

TEST(Stretches, OverDegrees) {
  Trajectory turn;
  for (int i = 0; i < 7; ++i) {
    turn.push_back(stamped(i, {0.0, 0.0, 0.0}, {0.0, 0.0, 4.0 * i * std::numbers::pi / 180.0}));
  }
  EXPECT_EQ(plain(find_pairs(turn, {.delta = 10.0, .unit = DeltaUnit::degrees})),
            (Pairs{{0, 3}, {3, 6}}));
  const PairOptions all{.delta = 8.1, .unit = DeltaUnit::degrees, .all_pairs = true};
  EXPECT_EQ(plain(find_pairs(turn, all)), (Pairs{{0, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}}));
}

TEST(Stretches, ImpossibleLengthsAreErrors) {
  const Trajectory walk = straight_walk(5, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double delta : {0.0, -1.0, 1.5, nan, inf}) {
    EXPECT_THROW((void)find_pairs(walk, {.delta = delta}), std::invalid_argument) << delta;
  }
  EXPECT_THROW((void)find_pairs(walk, {.delta = 181.0, .unit = DeltaUnit::degrees}),
               std::invalid_argument);
}

TEST(Stretches, OfTrajectoriesWithFewPoses) {
  for (const DeltaUnit unit :
       {DeltaUnit::frames, DeltaUnit::metres, DeltaUnit::seconds, DeltaUnit::degrees}) {
    for (const bool all : {false, true}) {
      EXPECT_TRUE(find_pairs({}, {.unit = unit, .all_pairs = all}).empty());
      EXPECT_TRUE(find_pairs(straight_walk(1, 1.0), {.unit = unit, .all_pairs = all}).empty());
    }
  }
}

TEST(RelativeErrors, DoNotDependOnTheWorldFrames) {
  const Trajectory reference = winding_walk(40);
  const Pose motion{from_roll_pitch_yaw({0.5, -0.4, 2.0}), {100.0, 5.0, -3.0}};
  const std::vector<IndexPair> stretches = find_pairs(reference, {.delta = 5.0});
  for (const double error :
       relative_errors({reference, test::moved(reference, motion)}, stretches, Relation::full)) {
    EXPECT_NEAR(error, 0.0, 1e-9);
  }
}

TEST(RelativeErrors, OfAStrideThatIsFivePercentTooLong) {
  const AssociatedTrajectories pairs{straight_walk(11, 1.0), straight_walk(11, 1.05)};
  const std::vector<IndexPair> stretches = find_pairs(pairs.reference, {.delta = 2.0});
  ASSERT_EQ(stretches.size(), 5U);
  for (const double error : relative_errors(pairs, stretches, Relation::translation)) {
    EXPECT_NEAR(error, 0.1, 1e-12);
  }
  for (const double error : relative_distance_errors(pairs, stretches)) {
    EXPECT_NEAR(error, 0.1, 1e-12);
  }
  for (const double error : relative_distance_error_percents(pairs, stretches)) {
    EXPECT_NEAR(error, 5.0, 1e-9);
  }
}

TEST(RelativeErrors, PercentsLeaveOutWhereTheReferenceStands) {
  const AssociatedTrajectories pairs{straight_walk(3, 0.0), straight_walk(3, 1.0)};
  EXPECT_TRUE(relative_distance_error_percents(pairs, {{0, 1}, {1, 2}}).empty());
}

}  // namespace
}  // namespace surefoot::evaluation
