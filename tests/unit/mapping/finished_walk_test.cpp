// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/finished_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "unit/mapping/post_and_wall.hpp"

namespace surefoot::mapping {
namespace {

FinishedWalk finished(const std::vector<Piece>& pieces) {
  MapperOptions options;
  options.close_loops = false;
  WalkMapper mapper(options);
  for (const Piece& piece : pieces) mapper.add(piece);
  mapper.finish();
  return FinishedWalk(mapper);
}

/// Six pieces of ten seconds each; in the middle two the odometry is in a frame of its own.
std::vector<Piece> away_and_home() {
  std::vector<Piece> pieces(6);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].begin_ns = static_cast<std::int64_t>(i) * 10'000'000'000;
    pieces[i].stamp_ns = pieces[i].time_ns = pieces[i].begin_ns + 5'000'000'000;
    pieces[i].T_world_piece.translation.x() = i < 4 ? 5.0 * static_cast<double>(i) : 1.0;
    pieces[i].covariance = 1e-6 * Matrix6::Identity();
    pieces[i].frame = i == 2 || i == 3 ? 1 : 0;
    pieces[i].restarted = i == 2 || i == 4;
    pieces[i].eyes = {Eigen::Vector3f::Zero()};
    pieces[i].points = {{1.0F, 0.0F, 0.0F}};
    pieces[i].seen_from = {0};
  }
  return pieces;
}

TEST(FinishedWalk, ATimeIsInTheFrameOfThePieceThatHasBegun) {
  const FinishedWalk walk = finished(away_and_home());
  EXPECT_EQ(walk.frame_at(-1), 0U) << "before the first one";
  EXPECT_EQ(walk.frame_at(19'999'999'999), 0U);
  EXPECT_EQ(walk.frame_at(20'000'000'000), 1U);
  EXPECT_EQ(walk.frame_at(39'999'999'999), 1U);
  EXPECT_EQ(walk.frame_at(40'000'000'000), 0U) << "home";
  EXPECT_EQ(walk.frame_at(1'000'000'000'000), 0U);
}

TEST(FinishedWalk, PosesAreTakenApartWhereTheNextOneIsInAnotherFrame) {
  Trajectory measured;
  for (std::int64_t i = 0; i < 12; ++i) {
    measured.push_back({i * 5'000'000'000, {Eigen::Quaterniond::Identity(), {1.0 * i, 2.0, 3.0}}});
  }
  const std::vector<FramePoses> parts = finished(away_and_home()).corrected(measured);
  ASSERT_EQ(parts.size(), 3U);
  std::size_t next = 0;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    EXPECT_EQ(parts[part].frame, part % 2);
    ASSERT_EQ(parts[part].poses.size(), 4U);
    for (const StampedPose& pose : parts[part].poses) {
      EXPECT_EQ(pose.stamp_ns, measured[next].stamp_ns);
      const Eigen::Vector3d moved = pose.pose.translation - measured[next].pose.translation;
      EXPECT_LT(moved.norm(), 1e-9) << "no loop moves it";
      ++next;
    }
  }
}

TEST(FinishedWalk, OfNothingLeavesEverythingWhereItIs) {
  const FinishedWalk walk = finished({});
  ASSERT_TRUE(walk.correction(7));
  EXPECT_TRUE(walk.correction(7)->translation.isZero());
  EXPECT_EQ(walk.frame_at(7), 0U);
  EXPECT_TRUE(walk.map().pieces.empty());
  EXPECT_TRUE(walk.graph().poses.empty());
  EXPECT_EQ(walk.corrected({{7, Pose{}}}).size(), 1U);
}

bool is_of_post(const Eigen::Vector3f& point) {
  return std::abs(point.y() - 3.0F) < 0.02F && point.z() > 0.05F;
}

/// Of each piece so many points that came and went, of the post and of the rest, where all that was
/// seen is asked for.
struct Moved {
  std::vector<std::size_t> post, rest;
};
Moved moved_of(const std::vector<Piece>& pieces) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::int64_t> times;
  for (const Piece& piece : pieces) {
    for (const Eigen::Vector3f& point : piece.points) {
      points.push_back((piece.T_world_piece * point.cast<double>()).cast<float>());
      times.push_back(piece.begin_ns + 1000);
    }
  }
  const std::vector<bool> moved = finished(pieces).moved(points, times);
  EXPECT_EQ(moved.size(), points.size());
  Moved result{std::vector<std::size_t>(pieces.size()), std::vector<std::size_t>(pieces.size())};
  for (std::size_t i = 0; i < moved.size(); ++i) {
    auto& counts = is_of_post(points[i]) ? result.post : result.rest;
    if (moved[i]) ++counts[static_cast<std::size_t>(times[i] / 8'000'000'000)];
  }
  return result;
}

TEST(FinishedWalk, TellsOfPointsAlongTheWalkWhichCameAndWent) {
  const Moved went = moved_of(test::walk_past_post({10, 10, 10, 10, 0, 0, 0}));
  for (std::size_t piece = 0; piece < 4; ++piece) EXPECT_GT(went.post[piece], 60U) << piece;
  const std::vector<std::size_t> none(7);
  EXPECT_EQ(went.rest, none);
  const Moved stayed = moved_of(test::walk_past_post({0, 0, 0, 0, 0, 10, 10}));
  EXPECT_EQ(stayed.post, none);
  EXPECT_EQ(stayed.rest, none);
}

TEST(FinishedWalk, WhatOthersSawInAnotherFrameTellsNothingOfAPoint) {
  std::vector<Piece> pieces = test::walk_past_post({10, 0, 0, 0});
  EXPECT_GT(moved_of(pieces).post[0], 60U);
  for (std::size_t i = 1; i < pieces.size(); ++i) pieces[i].frame = 1;
  pieces[1].restarted = true;
  EXPECT_EQ(moved_of(pieces).post[0], 0U);
}

TEST(FinishedWalk, WhatCameAndWentIsDroppedFromItsMap) {
  const std::vector<Piece> pieces = test::walk_past_post({10, 10, 10, 10, 0, 0, 0});
  FinishedWalk walk = finished(pieces);
  walk.drop_moved();
  ASSERT_EQ(walk.map().pieces.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t left = cloud_of(walk.map().pieces[i])->points.size();
    if (i < 4) EXPECT_LT(left, pieces[i].points.size() - 60) << i;
    if (i >= 4) EXPECT_EQ(left, pieces[i].points.size()) << i;
  }
}

}  // namespace
}  // namespace surefoot::mapping
