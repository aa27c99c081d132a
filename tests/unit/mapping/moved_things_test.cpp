// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A wall that is always there, and a post in front of it that is not.
#include "mapping/moved_things.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "mapping/thing_sight.hpp"

namespace surefoot::mapping {
namespace {

constexpr float kEye = 0.5F;

constexpr int kAlways = 10;  // all of a piece's moments

/// One moment, from a place on the way along x: ground, a wall at y = 6, and the post at (3, 3) or
/// not.
KeptScan moment(int number, int when, bool post) {
  KeptScan look;
  look.stamp_ns = number * std::int64_t{8'000'000'000} + when * std::int64_t{600'000'000};
  look.eye = {0.0F, 0.0F, kEye};
  const auto see = [&](float x, float y, float z) {
    look.points.emplace_back(x - static_cast<float>(number), y, z);
  };
  for (float x = -6.0F; x < 12.0F; x += 0.1F) {
    for (float y = -5.0F; y < 6.0F; y += 0.5F) see(x, y, 0.0F);
    // The post hides what is behind it.
    const float side = static_cast<float>(number) + 0.5F * (x - static_cast<float>(number));
    for (float z = 0.1F; !(post && side > 2.7F && side < 3.4F) && z < 3.0F; z += 0.1F) {
      see(x, 6.0F, z);
    }
  }
  for (float side = 2.8F; post && side < 3.3F; side += 0.1F) {
    for (float z = 0.1F; z < 1.8F; z += 0.1F) see(side, 3.0F, z);
  }
  return look;
}

/// What was seen from there, the post for some moments of it, from one on.
Piece look(int number, int moments, int first = 0) {
  Piece piece;
  piece.begin_ns = number * std::int64_t{8'000'000'000};
  piece.stamp_ns = piece.begin_ns + 1'000'000'000;
  piece.T_world_piece.translation = {static_cast<double>(number), 0.0, 0.0};
  piece.eyes = {{0.0F, 0.0F, kEye}};
  std::vector<KeptScan> looks;
  for (int when = 0; when < kAlways; ++when) {
    looks.push_back(moment(number, when, when >= first && when < first + moments));
  }
  for (const Eigen::Vector3f& point : moment(number, 0, moments > 0).points) {
    piece.points.push_back(point);
    piece.seen_from.push_back(0);
  }
  const PieceGround ground(make_submap(piece));
  piece.things = std::make_shared<const StoredBytes>(seen_in(looks, ground));
  return piece;
}

std::vector<Piece> walk(const std::vector<int>& moments) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    pieces.push_back(look(static_cast<int>(i), moments[i]));
  }
  return pieces;
}

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
  const std::vector<Piece> pieces = walk({10, 10, 10, 10, 0, 0, 0});
  EXPECT_GT(gone_from(pieces, 0).post, 60U);
  EXPECT_GT(gone_from(pieces, 3).post, 60U);
  EXPECT_EQ(gone_from(pieces, 3).rest, 0U);
}

/// One piece later on may look past it.
TEST(MovedThings, WhatOnePieceSeesThroughLaterStays) {
  EXPECT_EQ(gone_from(walk({10, 10, 10, 10, 0}), 0).post, 0U);
}

/// What only ends beams, as the ground does, is nothing that stands there.
TEST(MovedThings, WhatStoodLowIsGoneThoughTheGroundIsNear) {
  const std::vector<Piece> pieces = walk({2, 0, 0, 0});
  MovedThings moved(pieces, {0, 0, 0, 0});
  const std::vector<bool> gone = moved.gone(0, pieces[0].points);
  std::size_t low = 0;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    low += gone[i] && pieces[0].points[i].z() < 0.55F ? 1 : 0;
  }
  EXPECT_GT(low, 0U);
}

TEST(MovedThings, WhatWasThereForAMomentIsGoneThoughNobodyLookedAgain) {
  const std::vector<Piece> pieces = walk({0, 0, 0, 2});
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
  const std::vector<Piece> pieces = walk({1, 1, 1, 1});
  for (std::size_t piece = 0; piece < 4; ++piece) {
    EXPECT_GT(gone_from(pieces, piece).post, 60U);
    EXPECT_EQ(gone_from(pieces, piece).rest, 0U);
  }
}

/// Hit in every second moment it is something thin that beams miss.
TEST(MovedThings, WhatIsHitAsOftenAsItIsMissedStays) {
  const std::vector<Piece> pieces = walk({5, 5, 5, 5});
  EXPECT_EQ(gone_from(pieces, 1).post, 0U);
}

TEST(MovedThings, WhatCameAndStayedIsThere) {
  const std::vector<Piece> pieces = walk({0, 0, 0, 0, 0, 10, 10});
  for (std::size_t piece = 5; piece < 7; ++piece) EXPECT_EQ(gone_from(pieces, piece).post, 0U);
}

TEST(MovedThings, WhatAlwaysStandsIsThere) {
  const std::vector<Piece> always = walk({10, 10, 10, 10});
  for (std::size_t piece = 0; piece < 4; ++piece) {
    EXPECT_EQ(gone_from(always, piece).post, 0U);
    EXPECT_EQ(gone_from(always, piece).rest, 0U);
  }
}

/// Where a piece lies against another is not known: what it saw tells nothing.
TEST(MovedThings, OnlyPiecesThatAreHeldTogetherTell) {
  const std::vector<Piece> pieces = walk({10, 0, 0, 0});
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
  std::vector<Piece> pieces = walk({2, 0, 0, 0});
  const std::size_t before = pieces[0].points.size();
  const std::vector<Piece> as_seen = pieces;
  MovedThings moved(as_seen, {0, 0, 0, 0});
  drop_moved(pieces, moved, nullptr);
  EXPECT_LT(cloud_of(pieces[0])->points.size(), before - 60);
  EXPECT_EQ(cloud_of(pieces[2])->points.size(), as_seen[2].points.size());
}

}  // namespace
}  // namespace surefoot::mapping
