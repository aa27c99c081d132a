// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A walk along a wall that is always there, and a post in front of it that is not.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mapping/submap.hpp"
#include "mapping/thing_sight.hpp"

namespace surefoot::test {

using mapping::KeptScan;
using mapping::Piece;

inline constexpr float kEye = 0.5F;

inline constexpr int kAlways = 10;  // all of a piece's moments

/// One moment, from a place on the way along x: ground, a wall at y = 6, and the post at (3, 3) or
/// not.
inline KeptScan moment(int number, int when, bool post) {
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
inline Piece look(int number, int moments, int first = 0) {
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
  const mapping::PieceGround ground(make_submap(piece));
  piece.things = std::make_shared<const mapping::StoredBytes>(mapping::seen_in(looks, ground));
  return piece;
}

/// A metre a piece; the post is there in so many moments of each.
inline std::vector<Piece> walk_past_post(const std::vector<int>& moments) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    pieces.push_back(look(static_cast<int>(i), moments[i]));
  }
  return pieces;
}

}  // namespace surefoot::test
