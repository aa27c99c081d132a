// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How far the map moves what the odometry said, at any time.
#include <gtest/gtest.h>

#include <vector>

#include "mapping/walk_mapper.hpp"

namespace surefoot::mapping {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

Piece piece_at(std::int64_t time_s, double x) {
  Piece piece;
  piece.begin_ns = (time_s - 5) * kSecond;
  piece.time_ns = time_s * kSecond;
  piece.T_world_piece.translation.x() = x;
  return piece;
}

/// Three pieces of which the corrected ones lie this much beside.
Eigen::Vector3d correction_of(const std::vector<Piece>& pieces, double time_s) {
  const double beside[3] = {0.0, 1.0, 5.0};
  std::vector<Pose> corrected;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    corrected.push_back(pieces[i].T_world_piece);
    corrected.back().translation.y() += beside[i];
  }
  return correction_at(pieces, corrected, static_cast<std::int64_t>(time_s * 1e9)).translation;
}

TEST(Correction, IsSpreadBetweenPiecesAndStaysBeforeTheFirstAndAfterTheLast) {
  const std::vector<Piece> pieces = {piece_at(10, 0.0), piece_at(20, 4.0), piece_at(30, 8.0)};
  for (const auto& [time_s, beside] :
       {std::pair(2.0, 0.0), {10.0, 0.0}, {15.0, 0.5}, {20.0, 1.0}, {27.5, 4.0}, {44.0, 5.0}}) {
    EXPECT_NEAR(correction_of(pieces, time_s).y(), beside, 1e-9) << time_s;
  }
  EXPECT_TRUE(correction_at({}, {}, 0).translation.isZero());
}

// Between two frames of the odometry there is no way on which to spread it.
TEST(Correction, ChangesAtOnceWhereTheOdometryBeganAnew) {
  std::vector<Piece> pieces = {piece_at(10, 0.0), piece_at(20, 4.0), piece_at(30, 8.0)};
  pieces[2].restarted = true;
  EXPECT_NEAR(correction_of(pieces, 24.9).y(), 1.0, 1e-9);
  EXPECT_NEAR(correction_of(pieces, 25.0).y(), 5.0, 1e-9);
  EXPECT_NEAR(correction_of(pieces, 15.0).y(), 0.5, 1e-9) << "the pieces before are of one";
}

}  // namespace
}  // namespace surefoot::mapping
