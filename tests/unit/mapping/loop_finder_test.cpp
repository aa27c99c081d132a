// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A place that is seen again after a long way, and why it is refused to be one.
#include "mapping/loop_finder.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace surefoot::mapping {
namespace {

constexpr double kLongWay = 1000.0;  // [m]

/// A room with walls that are nowhere alike, seen from its middle and from so far above its floor
/// [m]; with a ceiling, or high walls alone.
Piece room(float above, bool ceiling) {
  constexpr float kSpacing = 0.2F;
  Piece piece;
  piece.eyes = {Eigen::Vector3f::Zero()};
  const float high = ceiling ? 3.0F : 6.0F;
  const auto see = [&](float x, float y, float z) { piece.points.emplace_back(x, y, z - above); };
  const auto wall = [&](const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const float length = (to - from).norm();
    for (float s = 0.0F; s < length; s += kSpacing) {
      const Eigen::Vector2f at = from + s / length * (to - from);
      for (float z = 0.0F; z < high; z += kSpacing) see(at.x(), at.y(), z);
    }
  };
  for (float x = -9.0F; x < 10.0F; x += kSpacing) {
    for (float y = -6.0F; y < 8.0F; y += kSpacing) {
      see(x, y, 0.0F);
      if (ceiling) see(x, y, high);
    }
  }
  wall({-9.0F, -6.0F}, {10.0F, -6.0F});
  wall({-9.0F, 8.0F}, {3.0F, 8.0F});
  wall({-9.0F, -6.0F}, {-9.0F, 8.0F});
  wall({10.0F, -6.0F}, {10.0F, 4.0F});
  wall({-4.0F, 3.0F}, {-1.0F, 5.0F});
  wall({5.0F, -6.0F}, {5.0F, -2.0F});
  wall({6.0F, 2.0F}, {6.5F, 2.0F});
  piece.seen_from.assign(piece.points.size(), 0);
  piece.covariance = 1e-6 * Matrix6::Identity();
  return piece;
}

Piece at(Piece piece, const Eigen::Vector3d& place, double way) {
  piece.T_world_piece.translation = place;
  piece.way = way;
  return piece;
}

/// A bare floor a metre on, no part of any submap: one of its scans was not sure of its place.
Piece between(const Piece& piece) {
  Piece floor = piece;
  std::erase_if(floor.points, [](const Eigen::Vector3f& point) { return point.z() > -0.4F; });
  floor.seen_from.assign(floor.points.size(), 0);
  floor.covariance(0, 0) = 0.1 * 0.1;
  floor.way += 1.0;
  floor.restarted = false;
  return floor;
}

/// What of these is found for the last one.
std::vector<Loop> loops_of(const std::vector<Piece>& pieces, const LoopOptions& options) {
  LoopFinder finder(options);
  for (const Piece& piece : pieces) {
    finder.add(piece);
    finder.add(between(piece));
  }
  finder.finish();
  std::vector<Loop> loops;
  for (const Loop& loop : finder.loops()) {
    const bool is_one = loop.query == 2 * (pieces.size() - 1) && loop.place % 2 == 0;
    if (is_one) loops.push_back(loop);
  }
  return loops;
}

LoopVerdict verdict_of(const std::vector<Piece>& pieces, const LoopOptions& options = {}) {
  const std::vector<Loop> loops = loops_of(pieces, options);
  if (loops.empty()) {
    ADD_FAILURE() << "nothing was asked";
    return LoopVerdict::little_to_see;
  }
  EXPECT_EQ(loops[0].place, 0U);
  return loops[0].check.verdict;
}

/// An odometry that knows its way to some centimetres.
LoopOptions sure() {
  LoopOptions options;
  options.drift = {0.0005, 0.0012, 0.005, 0.0, 0.0};
  return options;
}

TEST(LoopFinder, APlaceThatIsSeenAgainIsTakenUnlessTheOdometryKnowsBetter) {
  const Piece here = room(0.5F, false);
  const auto seen_again = [&](double aside, const LoopOptions& options) {
    return verdict_of({at(here, {0.0, 0.0, 0.0}, 0.0), at(here, {aside, 0.0, 0.0}, kLongWay)},
                      options);
  };
  EXPECT_EQ(seen_again(3.0, {}), LoopVerdict::taken);
  EXPECT_EQ(seen_again(0.0, sure()), LoopVerdict::taken);
  EXPECT_EQ(seen_again(3.0, sure()), LoopVerdict::beyond_drift);
}

TEST(LoopFinder, UnderARoofNothingIsLiftedByMoreThanHalfAStorey) {
  const auto lifted = [](const Piece& here, double by) {
    return verdict_of({at(here, {0.0, 0.0, 0.0}, 0.0), at(here, {0.0, 0.0, by}, kLongWay)});
  };
  EXPECT_EQ(lifted(room(0.5F, true), 1.0), LoopVerdict::taken);
  EXPECT_EQ(lifted(room(0.5F, true), 1.5), LoopVerdict::other_storey);
  EXPECT_EQ(lifted(room(0.5F, true), -1.5), LoopVerdict::other_storey);
  EXPECT_EQ(lifted(room(0.5F, false), 1.5), LoopVerdict::taken) << "a hill that is climbed again";
}

TEST(LoopFinder, WhatIsSeenFromTheStoreyAboveIsNoReturn) {
  const auto seen_from = [](double higher) {
    return verdict_of(
        {at(room(0.5F, false), {0.0, 0.0, 0.0}, 0.0),
         at(room(0.5F + static_cast<float>(higher), false), {0.0, 0.0, higher}, kLongWay)});
  };
  EXPECT_EQ(seen_from(1.0), LoopVerdict::taken);
  EXPECT_EQ(seen_from(1.6), LoopVerdict::other_storey);
}

TEST(LoopFinder, OfTwoPlacesThatFitNeitherIsTaken) {
  LoopOptions options;
  options.drift.systematic_translation = 0.005;
  const Piece here = room(0.5F, false);
  const std::vector<Loop> loops =
      loops_of({at(here, {0.0, 0.0, 0.0}, 0.0), at(here, {20.0, 0.0, 0.0}, 100.0),
                at(here, {10.0, 0.0, 0.0}, kLongWay)},
               options);
  ASSERT_EQ(loops.size(), 2U);
  for (const Loop& loop : loops) EXPECT_EQ(loop.check.verdict, LoopVerdict::ambiguous);
}

/// From where the odometry has it nothing is found; where it only looks the same it is not asked.
TEST(LoopFinder, WhereTheOdometryRulesAPlaceOutItIsNotTriedThere) {
  const Piece here = room(0.5F, false);
  const auto first_asked = [&](double aside, double turned, const LoopOptions& options) {
    Piece again = at(here, {aside, 0.0, 0.0}, kLongWay);
    again.T_world_piece.rotation = so3_exp({0.0, 0.0, turned});
    const std::vector<Loop> loops = loops_of({at(here, {0.0, 0.0, 0.0}, 0.0), again}, options);
    EXPECT_EQ(loops.size(), 1U);
    return loops.empty() ? Pose{} : loops[0].check.alignment.T_target_source;
  };
  const auto is_tried_there = [&](double aside, double turned, const LoopOptions& options) {
    const Pose found = first_asked(aside, turned, options);
    return found.translation.norm() < 0.1 &&
           found.rotation.angularDistance(Eigen::Quaterniond::Identity()) < 0.02;
  };
  EXPECT_TRUE(is_tried_there(4.0, 0.0, sure()));
  EXPECT_FALSE(is_tried_there(8.0, 0.0, sure()));
  EXPECT_TRUE(is_tried_there(0.0, 0.3, sure()));
  EXPECT_FALSE(is_tried_there(0.0, 1.5, sure()));
  EXPECT_TRUE(is_tried_there(8.0, 0.8, {})) << "an odometry that may have gone so far astray";
}

TEST(LoopFinder, AsksNoPlaceThatCannotBeOneOfWhichNothingIsKnownOrThatWasJustLeft) {
  const Piece here = room(0.5F, false);
  const auto asked = [&](const Eigen::Vector3d& place, double way, bool restarted) {
    Piece again = at(here, place, way);
    again.restarted = restarted;
    return !loops_of({at(here, {0.0, 0.0, 0.0}, 0.0), again}, sure()).empty();
  };
  EXPECT_TRUE(asked({0.0, 0.0, 0.0}, kLongWay, false));
  EXPECT_FALSE(asked({0.0, 0.0, 0.0}, kLongWay, true)) << "the odometry began anew between";
  EXPECT_TRUE(asked({0.0, 0.0, 0.0}, 26.0, false));
  EXPECT_FALSE(asked({0.0, 0.0, 0.0}, 24.0, false)) << "just left";
  EXPECT_FALSE(asked({12.0, 0.0, 0.0}, kLongWay, false)) << "too far away";
}

}  // namespace
}  // namespace surefoot::mapping
