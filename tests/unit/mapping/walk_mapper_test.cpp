// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Walks that return through simulated scenes: loops are found, none is false, and what the odometry
// got wrong is corrected.
#include "mapping/walk_mapper.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "mapping/finished_walk.hpp"
#include "mapping/map_localizer.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "mapping/stretches.hpp"
#include "unit/mapping/scene_walk.hpp"

namespace surefoot::mapping {
namespace {

using test::SceneWalk;
using test::WalkOptions;

WalkMapper mapped(const SceneWalk& walk) {
  WalkMapper mapper{MapperOptions{}};
  for (std::size_t i = 0; i < walk.scans.size(); ++i) mapper.add(walk.scans[i], walk.points[i]);
  mapper.finish();
  return mapper;
}

Pose true_piece(const SceneWalk& walk, const Piece& piece) {
  return walk.truth[static_cast<std::size_t>(piece.stamp_ns / 500'000'000)] *
         piece.T_piece_lidar.inverse();
}

void expect_no_false_loop(const SceneWalk& walk, const WalkMapper& mapper) {
  for (const Loop& loop : mapper.loops()) {
    if (loop.check.verdict != LoopVerdict::taken) continue;
    const Pose motion = true_piece(walk, mapper.pieces()[loop.place]).inverse() *
                        true_piece(walk, mapper.pieces()[loop.query]);
    const AlignmentGap gap = gap_between(loop.check.alignment, motion);
    EXPECT_LT(gap.metres, 0.3) << "pieces " << loop.place << " and " << loop.query;
    EXPECT_LT(gap.degrees, 1.5) << "pieces " << loop.place << " and " << loop.query;
  }
}

double worst_piece(const SceneWalk& walk, const WalkMapper& mapper) {
  double worst = 0.0;
  for (std::size_t i = 0; i < mapper.pieces().size(); ++i) {
    const Pose truth = true_piece(walk, mapper.pieces()[i]);
    worst = std::max(worst, (mapper.graph().poses[i].translation - truth.translation).norm());
  }
  return worst;
}

TEST(WalkMapperTest, ALapThatIsWalkedAgainIsFoundAndTheDriftTakenBack) {
  if (!has_solver()) GTEST_SKIP() << "built without Ceres";
  WalkOptions options;
  options.length = 150.0;
  options.yaw_drift = 3e-4;
  options.rise = 0.001;
  const SceneWalk walk = test::walk_through("campus", 41, options);
  const WalkMapper mapper = mapped(walk);
  EXPECT_GE(mapper.taken(), 4U);
  expect_no_false_loop(walk, mapper);
  const double before =
      (walk.scans.back().T_world_lidar.translation - walk.truth.back().translation).norm();
  const Pose corrected =
      mapper.correction(walk.scans.back().stamp_ns) * walk.scans.back().T_world_lidar;
  EXPECT_LT((corrected.translation - walk.truth.back().translation).norm(), 0.5 * before);
}

/// A submap is registered where it lies, whatever the start, and the other way round likewise.
TEST(WalkMapperTest, TwoSubmapsOfACampusAreRegisteredWhereTheyLie) {
  WalkOptions options;
  options.length = 22.0;
  const SceneWalk walk = test::walk_through("campus", 42, options);
  PieceBuilder builder{PieceOptions{}};
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    if (auto piece = builder.add(walk.scans[i], walk.points[i])) pieces.push_back(*piece);
  }
  ASSERT_GE(pieces.size(), 3U);
  const RegistrationSubmap a(make_submap(pieces, 1));
  const RegistrationSubmap b(make_submap(pieces, 2));
  const Pose T_a_b = pieces[1].T_world_piece.inverse() * pieces[2].T_world_piece;
  const Pose off = se3_exp((Twist() << 0.6, -0.5, 0.2, 0.0, 0.02, 0.08).finished());
  const SubmapAlignment found = align_submaps(a, b, T_a_b * off);
  EXPECT_EQ(found.held, 6);
  EXPECT_GT(found.matched, 0.6);
  EXPECT_LT(gap_between(found, T_a_b).metres, 0.03);
  EXPECT_LT(gap_between(found, T_a_b).degrees, 0.2);
  const SubmapAlignment back = align_submaps(b, a, (T_a_b * off).inverse());
  EXPECT_LT(gap_between(back, T_a_b.inverse()).metres, 0.03);
}

/// From an unknown start, by another robot's way through, among other things that stand about.
void expect_right_or_not_found(const MapLocalizer& localizer, const SceneWalk& walk,
                               std::size_t i) {
  if (!localizer.T_map_world()) return;
  const Pose found = *localizer.T_map_world() * walk.scans[i].T_world_lidar;
  EXPECT_LT((found.translation - walk.truth[i].translation).norm(), 0.3) << "scan " << i;
}

SavedMap map_of_campus() {
  WalkOptions options;
  options.length = 90.0;
  return saved_map_of(mapped(test::walk_through("campus", 46, options)));
}

TEST(LocalizerTest, FindsItsPlaceFromAnUnknownStartAndKeepsIt) {
  const SavedMap map = map_of_campus();
  WalkOptions options;
  options.unknown_start = true;
  options.things = 99;
  options.length = 25.0;
  options.yaw_drift = 1e-3;
  for (const double from : {10.0, 35.0, 60.0}) {
    options.from = from;
    const SceneWalk walk = test::walk_through("campus", 46, options);
    MapLocalizer localizer(map, {});
    std::size_t found = 0;
    for (std::size_t i = 0; i < walk.scans.size(); ++i) {
      localizer.add(walk.scans[i], walk.points[i]);
      expect_right_or_not_found(localizer, walk, i);
      found += localizer.T_map_world() ? 1 : 0;
    }
    EXPECT_GT(found, walk.scans.size() / 3) << "from " << from << ": " << localizer.message();
  }
}

/// The other map's pieces in a frame of their own, each just where one of the map's lies in its
/// frame; they come first.
SavedMap with_another_frame(const SavedMap& map, const SavedMap& other) {
  SavedMap both = other;
  for (std::size_t i = 0; i < both.pieces.size(); ++i) {
    both.pieces[i].T_world_piece = map.pieces[i % map.pieces.size()].T_world_piece;
  }
  const std::size_t offset = both.pieces.size();
  both.pieces.insert(both.pieces.end(), map.pieces.begin(), map.pieces.end());
  both.pieces[offset].restarted = true;
  both.places.insert(both.places.end(), map.places.begin(), map.places.end());
  for (PoseEdge edge : map.edges) {
    edge.from += offset;
    edge.to += offset;
    both.edges.push_back(edge);
  }
  return both;
}

TEST(LocalizerTest, IsConfirmedByTheFrameThatItIsInAlone) {
  WalkOptions options;
  options.length = 60.0;
  const SavedMap plaza = saved_map_of(mapped(test::walk_through("plaza", 47, options)));
  const SavedMap campus = saved_map_of(mapped(test::walk_through("campus", 46, options)));
  options.unknown_start = true;
  const SceneWalk walk = test::walk_through("campus", 46, options);
  MapLocalizer localizer(with_another_frame(campus, plaza), {});
  bool found = false;
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    localizer.add(walk.scans[i], walk.points[i]);
    expect_right_or_not_found(localizer, walk, i);
    ASSERT_TRUE(!found || localizer.T_map_world()) << i << ": " << localizer.message();
    found = found || localizer.T_map_world();
  }
  EXPECT_TRUE(found) << localizer.message();
}

/// Once the place is known, few scans are looked at: to make their points takes time. And it is
/// still noticed where the map no longer agrees.
TEST(LocalizerTest, AKnownPlaceIsCheckedByFewScans) {
  const SavedMap map = map_of_campus();
  WalkOptions options;
  options.unknown_start = true;
  options.length = 80.0;
  const SceneWalk walk = test::walk_through("campus", 46, options);
  const SceneWalk elsewhere = test::walk_through("plaza", 47, options);
  MapLocalizer localizer(map, {});
  std::size_t known = 0;
  std::size_t looked_at = 0;
  const auto add = [&](std::size_t i, const DeskewedScan& points) {
    known += localizer.T_map_world() ? 1 : 0;
    localizer.add(walk.scans[i], [&]() -> const DeskewedScan& {
      looked_at += localizer.T_map_world() ? 1 : 0;
      return points;
    });
  };
  const std::size_t half = walk.scans.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    add(i, walk.points[i]);
    expect_right_or_not_found(localizer, walk, i);
  }
  ASSERT_TRUE(localizer.T_map_world()) << localizer.message();
  EXPECT_GT(looked_at, known / 10);
  EXPECT_LT(looked_at, known / 3);
  for (std::size_t i = half; i < walk.scans.size(); ++i) add(i, elsewhere.points[i]);
  EXPECT_FALSE(localizer.T_map_world());
}

/// Way on which the place was not known yet [m]; looks(i) after every scan.
template <typename Looks>
double way_until_found(MapLocalizer& localizer, const SceneWalk& walk, const Looks& looks) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    localizer.add(walk.scans[i], walk.points[i]);
    looks(i);
    before += localizer.T_map_world() ? 0 : 1;
  }
  return static_cast<double>(before) * WalkOptions{}.step;
}

/// A place is looked at every 8 m, and once more 2 m later: where both say the same, the odometry
/// has drifted, and the place is not lost.
TEST(LocalizerTest, WhatTwoLooksSayIsBelieved) {
  const SavedMap map = map_of_campus();
  WalkOptions options;
  options.unknown_start = true;
  options.length = 80.0;
  SceneWalk walk = test::walk_through("campus", 46, options);
  const std::size_t half = walk.scans.size() / 2;
  const Pose slip{Eigen::Quaterniond::Identity(), {0.4, 0.3, 0.0}};
  for (std::size_t i = half; i < walk.scans.size(); ++i) {
    walk.scans[i].T_world_lidar = slip * walk.scans[i].T_world_lidar;
  }
  MapLocalizer localizer(map, {});
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    localizer.add(walk.scans[i], walk.points[i]);
    EXPECT_TRUE(localizer.T_map_world() || i < half) << i << ": " << localizer.message();
  }
  expect_right_or_not_found(localizer, walk, walk.scans.size() - 1);
}

/// What fits badly is found once searches have agreed on some way, what fits well at once.
TEST(LocalizerTest, WhileTheRobotStandsAPlaceHasToFitWell) {
  WalkOptions options;
  options.length = 60.0;
  const SavedMap map = saved_map_of(mapped(test::walk_through("campus", 46, options)));
  options.unknown_start = true;
  options.from = 20.0;
  options.length = 14.0;
  const SceneWalk walk = test::walk_through("campus", 46, options);
  for (const double fit_standing : {0.0, 1.1}) {
    LocalizerOptions asked;
    asked.agreement.fit_standing = fit_standing;
    asked.agreement.way = 6.0;
    MapLocalizer localizer(map, asked);
    const double way = way_until_found(
        localizer, walk, [&](std::size_t i) { expect_right_or_not_found(localizer, walk, i); });
    EXPECT_TRUE(localizer.T_map_world()) << localizer.message();
    EXPECT_EQ(way >= asked.agreement.way, fit_standing > 1.0) << way;
  }
}

/// A street that was mapped, and a walk through it from its beginning on another day.
std::pair<SavedMap, SceneWalk> street_on_another_day(std::uint64_t seed) {
  WalkOptions options;
  options.length = 60.0;
  SavedMap map = saved_map_of(mapped(test::walk_through("street", seed, options)));
  options.unknown_start = true;
  options.from = 4.0;
  options.length = 14.0;
  options.things = 99;
  return {std::move(map), test::walk_through("street", seed, options)};
}

/// Two places look alike at first. That the other one is not named any more says little.
TEST(LocalizerTest, AfterPlacesWereAlikeOtherThingsHaveToBeSeen) {
  const auto [map, walk] = street_on_another_day(46);
  for (const double alike_way : {0.0, 6.0}) {
    LocalizerOptions asked;
    asked.agreement.alike_way = alike_way;
    MapLocalizer localizer(map, asked);
    const double way = way_until_found(
        localizer, walk, [&](std::size_t i) { expect_right_or_not_found(localizer, walk, i); });
    EXPECT_TRUE(localizer.T_map_world()) << localizer.message();
    EXPECT_EQ(way >= 6.0, alike_way > 0.0) << way;
  }
}

/// Every search names a single place: that another one fitted before is not forgotten.
TEST(LocalizerTest, WhatASearchNamesNoMoreIsAskedAgain) {
  const auto [map, walk] = street_on_another_day(48);
  LocalizerOptions asked;
  asked.candidates = 1;
  MapLocalizer localizer(map, asked);
  bool several = false;
  way_until_found(localizer, walk, [&](std::size_t i) {
    expect_right_or_not_found(localizer, walk, i);
    several = several || localizer.message().find("several") != std::string::npos;
  });
  EXPECT_TRUE(several);
}

TEST(LocalizerTest, AnotherSceneIsNotFound) {
  WalkOptions options;
  options.length = 60.0;
  const SavedMap map = saved_map_of(mapped(test::walk_through("campus", 46, options)));
  options.length = 25.0;
  const SceneWalk walk = test::walk_through("plaza", 47, options);
  MapLocalizer localizer(map, {});
  for (std::size_t i = 0; i < walk.scans.size(); ++i) {
    localizer.add(walk.scans[i], walk.points[i]);
    EXPECT_FALSE(localizer.T_map_world()) << "scan " << i;
  }
  EXPECT_NE(localizer.message().find("not found yet"), std::string::npos);
}

/// Where several storeys fit, none is named.
TEST(LocalizerTest, AStoreyIsNotTakenForAnother) {
  WalkOptions options;
  options.length = 130.0;
  const SavedMap map = saved_map_of(mapped(test::walk_through("storeys", 48, options)));
  options.unknown_start = true;
  options.length = 20.0;
  for (const double from : {5.0, 50.0, 80.0}) {
    options.from = from;
    const SceneWalk walk = test::walk_through("storeys", 48, options);
    MapLocalizer localizer(map, {});
    for (std::size_t i = 0; i < walk.scans.size(); ++i) {
      localizer.add(walk.scans[i], walk.points[i]);
      expect_right_or_not_found(localizer, walk, i);
    }
  }
}

/// Four storeys with the same furniture: none is taken for another, though they look it.
TEST(WalkMapperTest, StoreysThatLookAlikeAreNotTakenForEachOther) {
  WalkOptions options;
  options.length = 150.0;
  options.rise = 0.002;
  const SceneWalk walk = test::walk_through("storeys", 43, options);
  const WalkMapper mapper = mapped(walk);
  EXPECT_FALSE(mapper.loops().empty());
  expect_no_false_loop(walk, mapper);
  EXPECT_LT(worst_piece(walk, mapper), 0.6);
}

TEST(WalkMapperTest, BaysThatLookAlikeAreNotTakenForEachOther) {
  WalkOptions options;
  options.length = 180.0;
  options.yaw_drift = 2e-4;
  const SceneWalk walk = test::walk_through("bays", 44, options);
  const WalkMapper mapper = mapped(walk);
  EXPECT_FALSE(mapper.loops().empty());
  expect_no_false_loop(walk, mapper);
}

/// What agrees before a beginning anew does not outvote what agrees after it.
TEST(WalkMapperTest, StretchesKeepLoopsOfTheirOwn) {
  if (!has_solver()) GTEST_SKIP() << "built without Ceres";
  WalkOptions options;
  options.length = 150.0;
  SceneWalk walk = test::walk_through("plaza", 47, options);
  const SceneWalk campus = test::walk_through("campus", 46, options);
  const std::size_t first = walk.scans.size();
  for (std::size_t i = 0; i < campus.scans.size(); ++i) {
    walk.scans.push_back(campus.scans[i]);
    walk.scans.back().stamp_ns += static_cast<std::int64_t>(first) * 500'000'000;
    walk.scans.back().restarted = i == 0;
    walk.points.push_back(campus.points[i]);
    walk.truth.push_back(campus.truth[i]);
  }
  const WalkMapper mapper = mapped(walk);
  const std::vector<std::size_t> stretches = stretches_of(mapper.pieces());
  std::vector<std::size_t> taken(2, 0);
  for (const Loop& loop : mapper.loops()) {
    if (loop.check.verdict != LoopVerdict::taken) continue;
    EXPECT_EQ(stretches[loop.place], stretches[loop.query]);
    ++taken[stretches[loop.query]];
  }
  EXPECT_GE(taken[0], 2U);
  EXPECT_GE(taken[1], 2U);
}

TEST(WalkMapperTest, TheSameWalkGivesTheSameBits) {
  WalkOptions options;
  options.length = 60.0;
  const SceneWalk walk = test::walk_through("corridor", 45, options);
  const WalkMapper one = mapped(walk);
  const WalkMapper two = mapped(walk);
  ASSERT_EQ(one.graph().poses.size(), two.graph().poses.size());
  for (std::size_t i = 0; i < one.graph().poses.size(); ++i) {
    EXPECT_EQ(one.graph().poses[i].translation, two.graph().poses[i].translation);
  }
}

}  // namespace
}  // namespace surefoot::mapping
