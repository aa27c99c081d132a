// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A wall that is always there, and a post in front of it that is not.
#include "mapping/moved_things.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "unit/mapping/post_and_wall.hpp"

namespace surefoot::mapping {
namespace {

using test::look;

/// How many points of the post, and of all else, are gone from a piece.
struct Gone {
  std::size_t post = 0, rest = 0;
};
Gone gone_from(const std::vector<Piece>& pieces, std::size_t piece,
               std::vector<std::size_t> held = {}) {
  if (held.empty()) held.assign(pieces.size(), 0);
  MovedThings moved(pieces, held);
  const std::vector<bool> gone = moved.gone(piece, pieces[piece].points);
  Gone result;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    const bool of_post = pieces[piece].points[i].y() == 3.0F && pieces[piece].points[i].z() > 0.05F;
    (of_post ? result.post : result.rest) += gone[i] ? 1 : 0;
  }
  return result;
}

TEST(MovedThings, WhatWentLaterIsGone) {
  const std::vector<Piece> pieces = test::walk_past_post({10, 10, 10, 10, 0, 0, 0});
  EXPECT_GT(gone_from(pieces, 0).post, 60U);
  EXPECT_GT(gone_from(pieces, 3).post, 60U);
  EXPECT_EQ(gone_from(pieces, 3).rest, 0U);
}

/// One piece later on may look past it.
TEST(MovedThings, WhatOnePieceSeesThroughLaterStays) {
  EXPECT_EQ(gone_from(test::walk_past_post({10, 10, 10, 10, 0}), 0).post, 0U);
}

/// What only ends beams, as the ground does, is nothing that stands there.
TEST(MovedThings, WhatStoodLowIsGoneThoughTheGroundIsNear) {
  const std::vector<Piece> pieces = test::walk_past_post({2, 0, 0, 0});
  MovedThings moved(pieces, {0, 0, 0, 0});
  const std::vector<bool> gone = moved.gone(0, pieces[0].points);
  std::size_t low = 0;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    low += gone[i] && pieces[0].points[i].z() < 0.55F ? 1 : 0;
  }
  EXPECT_GT(low, 0U);
}

TEST(MovedThings, WhatWasThereForAMomentIsGoneThoughNobodyLookedAgain) {
  const std::vector<Piece> pieces = test::walk_past_post({0, 0, 0, 2});
  EXPECT_GT(gone_from(pieces, 3).post, 60U);
  EXPECT_EQ(gone_from(pieces, 3).rest, 0U);
}

/// Seen through before and after by the very piece that saw it.
TEST(MovedThings, WhoWalksByIsGoneThoughOnlyOnePieceLooked) {
  const std::vector<Piece> pieces = {look(0, 1, 4)};
  EXPECT_GT(gone_from(pieces, 0).post, 60U);
  EXPECT_EQ(gone_from(pieces, 0).rest, 0U);
}

/// All pieces see something there, each for a moment: others.
TEST(MovedThings, WhereOthersKeepWalkingByAllOfThemAreGone) {
  const std::vector<Piece> pieces = test::walk_past_post({1, 1, 1, 1});
  for (std::size_t piece = 0; piece < 4; ++piece) {
    EXPECT_GT(gone_from(pieces, piece).post, 60U);
    EXPECT_EQ(gone_from(pieces, piece).rest, 0U);
  }
}

/// Hit in every second moment it is something thin that beams miss.
TEST(MovedThings, WhatIsHitAsOftenAsItIsMissedStays) {
  const std::vector<Piece> pieces = test::walk_past_post({5, 5, 5, 5});
  EXPECT_EQ(gone_from(pieces, 1).post, 0U);
}

TEST(MovedThings, WhatCameAndStayedIsThere) {
  const std::vector<Piece> pieces = test::walk_past_post({0, 0, 0, 0, 0, 10, 10});
  for (std::size_t piece = 5; piece < 7; ++piece) EXPECT_EQ(gone_from(pieces, piece).post, 0U);
}

TEST(MovedThings, WhatAlwaysStandsIsThere) {
  const std::vector<Piece> always = test::walk_past_post({10, 10, 10, 10});
  for (std::size_t piece = 0; piece < 4; ++piece) {
    EXPECT_EQ(gone_from(always, piece).post, 0U);
    EXPECT_EQ(gone_from(always, piece).rest, 0U);
  }
}

/// Where a piece lies against another is not known: what it saw tells nothing.
TEST(MovedThings, OnlyPiecesThatAreHeldTogetherTell) {
  const std::vector<Piece> pieces = test::walk_past_post({10, 0, 0, 0});
  EXPECT_GT(gone_from(pieces, 0, {0, 0, 0, 0}).post, 60U);
  EXPECT_EQ(gone_from(pieces, 0, {0, 1, 1, 1}).post, 0U);
  PoseGraph graph;
  graph.poses.resize(3);
  PoseEdge edge;
  edge.to = 1;
  graph.edges = {edge};
  EXPECT_EQ(held_together(graph), (std::vector<std::size_t>{0, 0, 2}));
}

TEST(MovedThings, AreDroppedFromTheClouds) {
  std::vector<Piece> pieces = test::walk_past_post({2, 0, 0, 0});
  const std::size_t before = pieces[0].points.size();
  const std::vector<Piece> as_seen = pieces;
  MovedThings moved(as_seen, {0, 0, 0, 0});
  drop_moved(pieces, moved, nullptr);
  EXPECT_LT(cloud_of(pieces[0])->points.size(), before - 60);
  EXPECT_EQ(cloud_of(pieces[2])->points.size(), as_seen[2].points.size());
}

}  // namespace
}  // namespace surefoot::mapping
