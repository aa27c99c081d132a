// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/piece.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "mapping/submap.hpp"
#include "mapping/thing_sight.hpp"

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

/// Pieces of a straight way; one scan in the first is as uncertain as told.
std::vector<Piece> pieces_with(double sigma_pitch) {
  PieceBuilder builder{PieceOptions{}};
  DeskewedScan points;
  points.points = {{1.0F, 0.0F, 0.0F}};
  std::vector<Piece> pieces;
  for (int i = 0; i <= 60; ++i) {
    if (auto piece = builder.add(scan_at(0.25 * i, i == 7 ? sigma_pitch : 0.001), points)) {
      pieces.push_back(*piece);
    }
  }
  return pieces;
}

/// One scan that may be placed badly bends the piece, and every submap with that piece in it.
TEST(Piece, IsAsUncertainAsItsLeastCertainScan) {
  const std::vector<Piece> pieces = pieces_with(0.005);
  ASSERT_GE(pieces.size(), 3U);
  // The world's y axis is the piece's x axis: it is turned by 90 degrees.
  EXPECT_NEAR(pieces[0].covariance(3, 3), 0.005 * 0.005, 1e-9);
  EXPECT_NEAR(pieces[1].covariance(3, 3), 1e-6, 1e-9);
  EXPECT_NEAR(make_submap(pieces, 1).covariance(3, 3), 0.005 * 0.005, 1e-9);
  EXPECT_NEAR(make_submap(pieces, 2).covariance(3, 3), 1e-6, 1e-9);
}

/// Three degrees would bend the submap beyond what a loop may be off: it ends before.
TEST(Piece, ThatIsBentEndsASubmap) {
  const std::vector<Piece> pieces = pieces_with(0.05);
  EXPECT_NEAR(make_submap(pieces, 1).covariance(3, 3), 1e-6, 1e-9);
  EXPECT_LT(make_submap(pieces, 1).points.size(), make_submap(pieces_with(0.005), 1).points.size());
  EXPECT_NEAR(make_submap(pieces, 0).covariance(3, 3), 0.05 * 0.05, 1e-9) << "its own stays";
  std::vector<Piece> bent_last = pieces_with(0.001);
  bent_last.back().covariance(3, 3) = 0.05 * 0.05;
  EXPECT_NEAR(make_submap(bent_last, bent_last.size() - 2).covariance(3, 3), 1e-6, 1e-9);
}

/// How far the odometry's new frame lies from the one before is not known.
TEST(Piece, WhereTheOdometryBeganAnewASubmapEnds) {
  std::vector<Piece> pieces = pieces_with(0.001);
  ASSERT_EQ(pieces.size(), 3U);
  const auto points = [&](std::size_t i) { return make_submap(pieces, i).points.size(); };
  const std::size_t all = points(1), two = points(0);
  ASSERT_GT(all, two);
  pieces[1].restarted = true;
  EXPECT_EQ(points(0), make_submap(pieces[0]).points.size());
  EXPECT_LT(points(1), all);
  pieces[1].restarted = false;
  pieces[2].restarted = true;
  EXPECT_EQ(points(0), two);
  EXPECT_EQ(points(1), two);
  EXPECT_EQ(points(2), make_submap(pieces[2]).points.size());
}

TEST(Piece, LeavesOutWhatIsFarAwayAndAddsWhatIsSeenInATurn) {
  PieceOptions options;
  options.always = 1;
  PieceBuilder builder(options);
  PlacedScan scan = scan_at(0.0, 0.001);
  DeskewedScan points;
  points.points = {{5.0F, 0.0F, 0.0F}, {60.0F, 0.0F, 0.0F}};
  const auto seen = [&] {
    (void)builder.add(scan, points);
    return builder.unfinished()->points.size();
  };
  EXPECT_EQ(seen(), 1U);
  scan.T_world_lidar.rotation = so3_exp({0.0, 0.0, 0.5 * std::numbers::pi + 0.2});
  EXPECT_EQ(seen(), 1U) << "hardly another look";
  scan.T_world_lidar.rotation = so3_exp({0.0, 0.0, 0.5 * std::numbers::pi + 0.3});
  EXPECT_EQ(seen(), 2U);
}

/// Put away, it is the same but for the last millimetres.
TEST(Piece, ThatIsPutAwayIsStillThere) {
  std::vector<Piece> pieces = pieces_with(0.001);
  const std::size_t points = make_submap(pieces, 1).points.size();
  for (const auto& file : {CloudFile::make({}), std::shared_ptr<CloudFile>()}) {
    std::vector<Piece> away = pieces;
    for (Piece& piece : away) put_away(piece, file);
    EXPECT_TRUE(away[1].points.empty());
    const auto cloud = cloud_of(away[1]);
    ASSERT_EQ(cloud->points.size(), pieces[1].points.size());
    EXPECT_EQ(make_submap(away, 1).points.size(), points);
  }
}

/// Scans of a robot that stands for half a minute; for the first half somebody stands before it.
Piece stood(const PieceOptions& options) {
  PieceBuilder builder(options);
  for (int i = 0; i < 300; ++i) {
    PlacedScan scan = scan_at(0.0, 0.001);
    scan.stamp_ns = i * std::int64_t{100'000'000};
    DeskewedScan points;
    points.points = {{i < 150 ? 3.0F : 7.0F, 0.0F, 0.0F}, {2.0F, 2.0F, -0.5F}};
    EXPECT_FALSE(builder.add(scan, points).has_value());
  }
  return builder.finish().value();
}

/// Parked for an hour on the way.
TEST(Piece, OfOneWhoStandsForLongIsNoLarger) {
  PieceBuilder builder{PieceOptions{}};
  DeskewedScan points;
  points.points = {{1.0F, 0.0F, 0.0F}};
  PlacedScan scan = scan_at(0.0, 0.001);
  std::vector<std::size_t> places;
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    scan.T_world_lidar.translation.x() = x;
    for (int i = 0; i < (x == 2.0 ? 36'000 : 2); ++i) {
      scan.stamp_ns += 100'000'000;
      ASSERT_FALSE(builder.add(scan, points).has_value());
    }
    places.push_back(builder.places());
  }
  EXPECT_EQ(places, (std::vector<std::size_t>{1, 2, 3, 4}));
  const Piece piece = builder.finish().value();
  EXPECT_EQ(piece.T_world_piece.translation.x(), 1.0);
  EXPECT_EQ(piece.stamp_ns, 300'000'000) << "the first scan there";
}

TEST(Piece, OfOneWhoStandsSeesWhoGoes) {
  PieceOptions options;
  EXPECT_EQ(stood(options).things, nullptr) << "nobody asked";
  options.things = true;
  Piece piece = stood(options);
  for (int away = 0; away < 2; ++away) {
    ASSERT_NE(piece.things, nullptr);
    const ThingSight sight(piece.things->packed());
    const ThingSight::Moments seen =
        sight.at((piece.T_world_piece.inverse() * Eigen::Vector3d(0.0, 3.0, 0.0)));
    EXPECT_NEAR(seen.hit, 7, 1);
    EXPECT_NEAR(seen.through, 7, 1);
    put_away(piece, CloudFile::make({}));
  }
}

// When every second look is let go, the first one stays.
TEST(Piece, OfManyScansStillKnowsItsFirst) {
  PieceOptions options;
  options.things = true;
  PieceBuilder builder(options);
  for (int i = 0; i < 65; ++i) {
    PlacedScan scan = scan_at(0.0, 0.001);
    scan.stamp_ns = i * std::int64_t{100'000'000};
    DeskewedScan points;
    points.points = {{i == 0 ? 3.0F : 7.0F, 0.0F, 0.0F}, {2.0F, 2.0F, -0.5F}};
    EXPECT_FALSE(builder.add(scan, points).has_value());
  }
  const Piece piece = builder.finish().value();
  const ThingSight sight(piece.things->packed());
  EXPECT_EQ(sight.at(piece.T_world_piece.inverse() * Eigen::Vector3d(0.0, 3.0, 0.0)).hit, 1);
}

/// A robot that trots on the spot does not walk.
TEST(Piece, TheBodysSwayIsNoWay) {
  PieceBuilder builder{PieceOptions{}};
  DeskewedScan points;
  points.points = {{1.0F, 0.0F, 0.0F}};
  for (int i = 0; i < 200; ++i) {
    PlacedScan scan = scan_at(i % 2 == 0 ? 0.0 : 0.1, 0.001);
    scan.stamp_ns = i * std::int64_t{100'000'000};
    ASSERT_FALSE(builder.add(scan, points).has_value()) << i;
  }
  EXPECT_EQ(builder.unfinished()->length, 0.0);
}

}  // namespace
}  // namespace surefoot::mapping
