// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/piece.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mapping/submap.hpp"

namespace surefoot::mapping {
namespace {

PlacedScan scan_at(double x, double sigma_pitch) {
  PlacedScan scan;
  scan.stamp_ns = static_cast<std::int64_t>(x * 1e9);
  scan.T_world_lidar.translation.x() = x;
  scan.T_world_lidar.rotation = so3_exp({0.0, 0.0, 0.5 * std::numbers::pi});
  scan.covariance = 1e-6 * Matrix6::Identity();
  scan.covariance(4, 4) = sigma_pitch * sigma_pitch;
  return scan;
}

/// One scan that may be placed badly bends the piece, and every submap with that piece in it.
TEST(Piece, IsAsUncertainAsItsLeastCertainScan) {
  PieceBuilder builder{PieceOptions{}};
  DeskewedScan points;
  points.points = {{1.0F, 0.0F, 0.0F}};
  std::vector<Piece> pieces;
  for (int i = 0; i <= 60; ++i) {
    const double x = 0.25 * i;
    if (auto piece = builder.add(scan_at(x, i == 7 ? 0.03 : 0.001), points)) {
      pieces.push_back(*piece);
    }
  }
  ASSERT_GE(pieces.size(), 3U);
  // The world's y axis is the piece's x axis: it is turned by 90 degrees.
  EXPECT_NEAR(pieces[0].covariance(3, 3), 0.03 * 0.03, 1e-9);
  EXPECT_NEAR(pieces[1].covariance(3, 3), 1e-6, 1e-9);
  EXPECT_NEAR(make_submap(pieces, 1).covariance(3, 3), 0.03 * 0.03, 1e-9);
  EXPECT_NEAR(make_submap(pieces, 2).covariance(3, 3), 1e-6, 1e-9);
}

}  // namespace
}  // namespace surefoot::mapping
