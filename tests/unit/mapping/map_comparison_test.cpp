// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_comparison.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace surefoot::mapping {
namespace {

/// A corner of two walls and ground.
Piece corner_at(const Eigen::Vector3d& place) {
  Piece piece;
  piece.eyes = {{0.0F, 0.0F, 0.5F}};
  for (float s = -6.0F; s < 6.0F; s += 0.2F) {
    for (float t = 0.0F; t < 3.0F; t += 0.2F) {
      piece.points.emplace_back(s, 6.0F, t);
      piece.points.emplace_back(6.0F, s, t);
    }
    for (float t = -6.0F; t < 6.0F; t += 0.2F) piece.points.emplace_back(s, t, 0.0F);
  }
  piece.seen_from.assign(piece.points.size(), 0);
  piece.covariance = 1e-6 * Matrix6::Identity();
  piece.restarted = true;  // each for itself
  piece.T_world_piece.translation = place;
  return piece;
}

MapComparison compare(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  const std::vector<Piece> pieces = {corner_at(one), corner_at(other)};
  return TwoMaps(pieces).compare({0}, {1});
}

TEST(MapComparison, AsksPlacesThatLieOnEachOther) {
  const MapComparison same = compare({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(same.near, 1U);
  EXPECT_GT(same.overlap, 0.9);
  EXPECT_LT(same.contradicted, 0.02);
  const MapComparison beside = compare({0.0, 0.0, 0.0}, {2.0, 1.0, 0.0});
  EXPECT_EQ(beside.near, 1U);
  EXPECT_LT(beside.overlap, same.overlap);
}

// They see nothing in common, which says nothing of how the maps lie.
TEST(MapComparison, NeitherAnotherStoreyNorWhatIsFarAway) {
  EXPECT_EQ(compare({0.0, 0.0, 0.0}, {0.0, 0.0, 1.1}).near, 1U);
  EXPECT_EQ(compare({0.0, 0.0, 0.0}, {0.0, 0.0, 2.9}).near, 0U);
  EXPECT_EQ(compare({0.0, 0.0, 2.9}, {0.0, 0.0, 0.0}).near, 0U);
  EXPECT_EQ(compare({0.0, 0.0, 0.0}, {4.9, 0.0, 0.0}).near, 1U);
  EXPECT_EQ(compare({0.0, 0.0, 0.0}, {5.1, 0.0, 0.0}).near, 0U);
}

}  // namespace
}  // namespace surefoot::mapping
