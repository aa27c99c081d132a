// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Maps of one place are joined where the exact truth has them; look-alikes are not.
#include "mapping/map_merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/se3.hpp"
#include "mapping/finished_walk.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "unit/mapping/scene_walk.hpp"

namespace surefoot::mapping {
namespace {

using test::SceneWalk;
using test::WalkOptions;

SavedMap map_of(const SceneWalk& walk) {
  WalkMapper mapper{MapperOptions{}};
  for (std::size_t i = 0; i < walk.scans.size(); ++i) mapper.add(walk.scans[i], walk.points[i]);
  mapper.finish();
  return saved_map_of(mapper);
}

/// Another day: other things stand about, and it begins elsewhere, in a world of its own.
WalkOptions other_day(double from, double length) {
  WalkOptions options;
  options.from = from;
  options.length = length;
  options.unknown_start = true;
  options.things = 99;
  return options;
}

WalkOptions of_length(double length) {
  WalkOptions options;
  options.length = length;
  return options;
}

/// One day on a campus, and another that begins 20 m on: each walked once for all tests.
const SavedMap& campus() {
  static const SavedMap map = map_of(test::walk_through("campus", 46, of_length(60.0)));
  return map;
}
const SceneWalk& later_walk() {
  static const SceneWalk walk = test::walk_through("campus", 46, other_day(20.0, 60.0));
  return walk;
}
const SavedMap& later_campus() {
  static const SavedMap map = map_of(later_walk());
  return map;
}

/// The same campus for 90 m, and another day on most of it; likewise once.
const SavedMap& long_campus() {
  static const SavedMap map = map_of(test::walk_through("campus", 46, of_length(90.0)));
  return map;
}
const SceneWalk& later_long_walk() {
  static const SceneWalk walk = test::walk_through("campus", 46, other_day(5.0, 80.0));
  return walk;
}
const SavedMap& later_long_campus() {
  static const SavedMap map = map_of(later_long_walk());
  return map;
}

/// A walk down a hall of 40 x 14 m whose columns stand at equal places from both of its ends.
SavedMap walk_through_a_symmetric_hall() {
  std::vector<Eigen::Vector3d> hall;
  const auto upright = [&](double x, double y) {
    for (double z = 0.0; z < 4.0; z += 0.2) hall.emplace_back(x, y, z);
  };
  for (double x = -20.0; x <= 20.0; x += 0.2) {
    for (double y = -7.0; y <= 7.0; y += 0.2) {
      const bool wall = std::abs(x) > 19.9 || std::abs(y) > 6.9;
      wall ? upright(x, y) : void(hall.emplace_back(x, y, 0.0));
    }
  }
  for (const auto& [at_x, at_y] :
       {std::pair{3.0, 4.0}, {7.5, -3.0}, {9.0, 5.0}, {14.0, -4.5}, {16.5, 2.5}}) {
    for (const double end : {-1.0, 1.0}) {
      for (double side = 0.0; side < 1.2; side += 0.2) {
        upright(end * (at_x + side), end * at_y);
        upright(end * at_x, end * (at_y + side));
      }
    }
  }
  WalkMapper mapper{MapperOptions{}};
  for (int i = 0; i < 60; ++i) {
    PlacedScan scan;
    scan.stamp_ns = i * std::int64_t{100'000'000};
    scan.T_world_lidar.translation = {-15.0 + 0.5 * i, 0.0, 0.6};
    scan.covariance = 1e-6 * Matrix6::Identity();
    DeskewedScan points;
    for (const Eigen::Vector3d& point : hall) {
      points.points.emplace_back((point - scan.T_world_lidar.translation).cast<float>());
    }
    mapper.add(scan, points);
  }
  mapper.finish();
  return saved_map_of(mapper);
}

class MapMerge : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_solver()) GTEST_SKIP() << "built without Ceres";
  }
};

/// Both days on the campus, once for who goes on from there.
const MapJoin& two_days() {
  static const MapJoin join = join_maps(campus(), later_campus());
  return join;
}

TEST_F(MapMerge, TwoDaysOnACampusAreJoinedWhereTheyLie) {
  const SavedMap& first = campus();
  SavedMap second = later_campus();
  // A stretch that nothing holds to the rest is left out.
  second.pieces.back().restarted = true;
  for (PoseEdge& edge : second.edges) {
    if (edge.to + 1 == second.pieces.size()) edge.information = 1e-9 * Matrix6::Identity();
  }
  const MapJoin join = join_maps(first, second);
  ASSERT_TRUE(join.joint) << join.message;
  EXPECT_GE(join.taken, 3U);
  EXPECT_EQ(join.joint->pieces.size(), first.pieces.size() + second.pieces.size() - 1);
  EXPECT_EQ(join.joint->places.size(), join.joint->pieces.size());
  EXPECT_FALSE(join.placed.back());
  EXPECT_EQ(join.held(), second.pieces.size() - 1);
  // The first walk's world is the truth's, the second's begins level at its first pose.
  const Pose T_first_second = upright(later_walk().truth.front());
  for (std::size_t i = 0; i < first.pieces.size(); ++i) {
    const Pose gap = first.pieces[i].T_world_piece.inverse() * join.joint->pieces[i].T_world_piece;
    EXPECT_LT(gap.translation.norm(), 0.05) << "piece " << i;
  }
  for (std::size_t i = 0; i + 1 < second.pieces.size(); ++i) {
    ASSERT_TRUE(join.placed[i]);
    const Pose gap = (T_first_second * second.pieces[i].T_world_piece).inverse() * *join.placed[i];
    EXPECT_LT(gap.translation.norm(), 0.1) << "piece " << i;
    EXPECT_LT(so3_log(gap.rotation).norm(), 0.01) << "piece " << i;
  }
  EXPECT_TRUE(join.joint->pieces[join.first].restarted) << "no odometry leads there";
  ASSERT_TRUE(join.begin());
  const Pose off = T_first_second.inverse() * *join.begin();
  EXPECT_LT(off.translation.norm(), 0.1);
  EXPECT_LT(so3_log(off.rotation).norm(), 0.01);
  EXPECT_EQ(parse_map(format_map(*join.joint)).pieces.size(), join.joint->pieces.size());
}

TEST_F(MapMerge, AWalkThatIsJoinedHasItsPosesInTheMapsFrame) {
  WalkMapper mapper{MapperOptions{}};
  Trajectory measured;
  for (std::size_t i = 0; i < later_walk().scans.size(); ++i) {
    const PlacedScan& scan = later_walk().scans[i];
    mapper.add(scan, later_walk().points[i]);
    measured.push_back({scan.stamp_ns, scan.T_world_lidar});
  }
  mapper.finish();
  FinishedWalk walk(mapper);
  const MapJoin join = walk.join(campus());
  ASSERT_TRUE(join.joint) << join.message;
  EXPECT_EQ(walk.map().pieces.size(), join.joint->pieces.size());
  const std::vector<FramePoses> parts = walk.corrected(measured);
  ASSERT_EQ(parts.size(), 1U);
  ASSERT_EQ(parts[0].poses.size(), measured.size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const Pose gap = later_walk().truth[i].inverse() * parts[0].poses[i].pose;
    EXPECT_LT(gap.translation.norm(), 0.15) << "scan " << i;
  }
}

TEST_F(MapMerge, WhereEnoughPlacesAgreeTheOthersAreComparedOnlyWhereTheyLie) {
  const MapJoin& everywhere = two_days();
  MergeOptions options;
  options.survey = 5;
  options.enough = 3;
  const MapJoin guided = join_maps(campus(), later_campus(), options);
  ASSERT_TRUE(everywhere.joint) << everywhere.message;
  ASSERT_TRUE(guided.joint) << guided.message;
  EXPECT_LT(guided.loops.size(), everywhere.loops.size() * 3 / 4);
  EXPECT_GE(guided.taken + 1, everywhere.taken)
      << "what is not asked of twins is asked where it is";
  for (std::size_t i = 0; i < guided.placed.size(); ++i) {
    ASSERT_TRUE(guided.placed[i] && everywhere.placed[i]) << "piece " << i;
    const Pose gap = everywhere.placed[i]->inverse() * *guided.placed[i];
    EXPECT_LT(gap.translation.norm(), 0.05) << "piece " << i;
  }
}

/// The graph of two maps, as join_maps() makes it, as far as placing needs it.
MapPair pair_of(const std::vector<Piece>& pieces, std::size_t first) {
  MapPair pair{pieces, first, {}, {}};
  for (const Piece& piece : pieces) pair.steps.poses.push_back(piece.T_world_piece);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    if (i + 1 == first) continue;
    PoseEdge edge;
    edge.from = i;
    edge.to = i + 1;
    edge.T_from_to = pieces[i].T_world_piece.inverse() * pieces[i + 1].T_world_piece;
    edge.information = 1e4 * Matrix6::Identity();
    pair.steps.edges.push_back(edge);
  }
  pair.graph = pair.steps;
  return pair;
}

TEST_F(MapMerge, MoreLoopsThatAgreeOnWhatIsNotSoDoNotOutvoteTheMapsThemselves) {
  const MapJoin& join = two_days();
  std::vector<Loop> loops;
  for (const Loop& loop : join.loops) {
    if (is_taken(loop)) loops.push_back(loop);
  }
  const std::size_t right = loops.size();
  ASSERT_GE(right, 3U);
  const MapPair pair = pair_of(join.pieces, join.first);
  // All of the second map's pieces claim to be some metres beside where they are.
  const Pose T_first_second = upright(later_walk().truth.front());
  const Pose aside{Eigen::Quaterniond::Identity(), {6.0, 8.0, 0.0}};
  for (std::size_t query = join.first; query < join.pieces.size(); ++query) {
    Loop loop = loops[0];
    loop.query = query;
    loop.check.alignment.T_target_source = join.pieces[loop.place].T_world_piece.inverse() * aside *
                                           T_first_second * join.pieces[query].T_world_piece;
    loops.push_back(loop);
  }
  ASSERT_GT(loops.size(), 2 * right);
  const std::vector<MapPlacement> placements = find_placements(pair, loops, 8);
  ASSERT_EQ(placements.size(), 2U);
  EXPECT_GT(placements[0].taken, placements[1].taken);
  EXPECT_FALSE(fits(placements[0], {}));
  EXPECT_TRUE(fits(placements[1], {}));
  const Pose found = placements[1].pieces[join.first].T_world_piece;
  const Pose truth = T_first_second * join.pieces[join.first].T_world_piece;
  EXPECT_LT((found.translation - truth.translation).norm(), 0.1);
}

/// A walk of which nothing holds the pieces from `begin` on to those before; they lie in a frame of
/// their own.
SavedMap in_two_frames(SavedMap map, std::size_t begin) {
  const Pose T_new_old = se3_exp((Twist() << 12.0, -7.0, 1.5, 0.0, 0.0, 0.9).finished());
  for (std::size_t i = begin; i < map.pieces.size(); ++i) {
    map.pieces[i].T_world_piece = T_new_old * map.pieces[i].T_world_piece;
  }
  map.pieces[begin].restarted = true;
  std::erase_if(map.edges,
                [&](const PoseEdge& edge) { return (edge.from < begin) != (edge.to < begin); });
  return map;
}

TEST_F(MapMerge, StretchesThatNothingJoinsArePlacedEachWhereItLies) {
  const SavedMap &whole = long_campus(), &second = later_long_campus();
  const MapJoin join = join_maps(whole, in_two_frames(second, second.pieces.size() / 2));
  ASSERT_TRUE(join.joint) << join.message;
  EXPECT_EQ(join.held(), second.pieces.size());
  EXPECT_EQ(join.joint->pieces.size(), whole.pieces.size() + second.pieces.size());
  const Pose T_first_second = upright(later_long_walk().truth.front());
  for (std::size_t i = 0; i < second.pieces.size(); ++i) {
    ASSERT_TRUE(join.placed[i]) << "piece " << i;
    const Pose truth = T_first_second * second.pieces[i].T_world_piece;
    EXPECT_LT((join.placed[i]->translation - truth.translation).norm(), 0.15) << "piece " << i;
  }
}

/// The first map's frames stay as they are.
TEST_F(MapMerge, AMapThatBeganAnewIsJoinedToOneThatShowsItWhole) {
  const SavedMap torn = in_two_frames(long_campus(), long_campus().pieces.size() / 2);
  const MapJoin join = join_maps(torn, later_long_campus());
  ASSERT_TRUE(join.joint) << join.message;
  const Pose T_new_old = se3_exp((Twist() << 12.0, -7.0, 1.5, 0.0, 0.0, 0.9).finished());
  const Pose T_first_second = upright(later_long_walk().truth.front());
  ASSERT_TRUE(join.placed.front());
  const Pose old = T_first_second * join.pieces[join.first].T_world_piece;
  const double in_either =
      std::min((join.placed.front()->translation - old.translation).norm(),
               (join.placed.front()->translation - (T_new_old * old).translation).norm());
  EXPECT_LT(in_either, 0.15);
}

TEST_F(MapMerge, AJointMapIsJoinedAgain) {
  const MapJoin& join = two_days();
  ASSERT_TRUE(join.joint) << join.message;
  const SceneWalk walk = test::walk_through("campus", 46, other_day(35.0, 40.0));
  const MapJoin again = join_maps(*join.joint, map_of(walk));
  ASSERT_TRUE(again.joint) << again.message;
  const Pose truth = upright(walk.truth.front());
  ASSERT_TRUE(again.placed.front());
  const Pose begin = truth * again.pieces[again.first].T_world_piece;
  EXPECT_LT((again.placed.front()->translation - begin.translation).norm(), 0.1);
}

TEST_F(MapMerge, OtherPlacesStayApart) {
  const SavedMap plaza = map_of(test::walk_through("plaza", 47, other_day(0.0, 50.0)));
  const MapJoin join = join_maps(campus(), plaza);
  EXPECT_FALSE(join.joint);
  EXPECT_EQ(join.taken, 0U);
  EXPECT_FALSE(join.message.empty());
  EXPECT_FALSE(join.begin());
  EXPECT_FALSE(join_maps(campus(), SavedMap{}).joint);
  EXPECT_FALSE(join_maps(SavedMap{}, campus()).joint);
}

/// What tells one row of bays from the next has been moved since. The second walk goes where the
/// first one never was, and finds there what looks the same.
TEST_F(MapMerge, RowsOfEqualBaysStayApart) {
  for (const std::uint64_t layout : {101U, 104U}) {
    const SavedMap first = map_of(test::walk_through("bays", layout, of_length(70.0)));
    const MapJoin join =
        join_maps(first, map_of(test::walk_through("bays", layout, other_day(80.0, 60.0))));
    EXPECT_FALSE(join.joint) << layout;
    EXPECT_EQ(join.taken, 0U);
  }
}

/// Nothing tells which end is which.
TEST_F(MapMerge, AHallThatIsTheSameFromBothEndsIsNotJoined) {
  const SavedMap hall = walk_through_a_symmetric_hall();
  EXPECT_FALSE(join_maps(hall, hall).joint);
}

/// Either refused or right: of this corridor many stretches are the same from both ends.
TEST_F(MapMerge, ACorridorIsNotJoinedTheWrongWayRound) {
  const SavedMap first = map_of(test::walk_through("corridor", 45, of_length(60.0)));
  for (const double from : {10.0, 30.0}) {
    const SceneWalk walk = test::walk_through("corridor", 45, other_day(from, 50.0));
    const MapJoin join = join_maps(first, map_of(walk));
    if (!join.joint) continue;
    const Pose begin = upright(walk.truth.front()) * join.pieces[join.first].T_world_piece;
    ASSERT_TRUE(join.placed.front());
    EXPECT_LT((join.placed.front()->translation - begin.translation).norm(), 0.2) << from;
  }
}

TEST_F(MapMerge, EachRefusalSaysWhatWasMissing) {
  const auto refused = [&](const MergeOptions& options) {
    const MapJoin join = join_maps(campus(), later_campus(), options);
    EXPECT_FALSE(join.joint);
    EXPECT_EQ(join.taken, 0U);
    return join.message;
  };
  MergeOptions as_good;
  as_good.as_good = 0.0;
  EXPECT_NE(refused(as_good).find("no two places agree"), std::string::npos);
  MergeOptions spread;
  spread.spread = 1e3;
  EXPECT_NE(refused(spread).find("one place"), std::string::npos);
  MergeOptions overlap;
  overlap.overlap = 1.1;
  EXPECT_NE(refused(overlap).find("what else both maps have seen"), std::string::npos);
  MergeOptions contradicted;
  contradicted.contradicted = -0.1;
  EXPECT_NE(refused(contradicted).find("what else both maps have seen"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::mapping
