// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Walks on which the odometry lost its way: what lies on both sides of a beginning anew is joined
// where it is sure, and not otherwise.
#include "mapping/stretches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/se3.hpp"
#include "mapping/finished_walk.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "mapping/walk_mapper.hpp"
#include "unit/mapping/scene_walk.hpp"

namespace surefoot::mapping {
namespace {

using test::SceneWalk;
using test::WalkOptions;

constexpr std::int64_t kScan = 500'000'000;  // [ns] from one scan of a walk to the next

/// From this scan on the odometry is in a world of its own, `pause_ns` later.
void begin_anew(SceneWalk& walk, std::size_t scan, std::int64_t pause_ns) {
  const Pose T_new_old = se3_exp((Twist() << 12.0, -7.0, 1.5, 0.0, 0.0, 0.9).finished());
  walk.scans[scan].restarted = true;
  for (std::size_t i = scan; i < walk.scans.size(); ++i) {
    walk.scans[i].T_world_lidar = T_new_old * walk.scans[i].T_world_lidar;
    walk.scans[i].stamp_ns += pause_ns;
  }
}

WalkMapper mapped(const SceneWalk& walk) {
  WalkMapper mapper{MapperOptions{}};
  for (std::size_t i = 0; i < walk.scans.size(); ++i) mapper.add(walk.scans[i], walk.points[i]);
  mapper.finish();
  return mapper;
}

/// Where the walk's pieces truly are.
std::vector<Pose> true_pieces(const SceneWalk& walk, const WalkMapper& mapper) {
  std::vector<Pose> result;
  for (const Piece& piece : mapper.pieces()) {
    const auto scan = std::find_if(walk.scans.begin(), walk.scans.end(),
                                   [&](const auto& one) { return one.stamp_ns == piece.stamp_ns; });
    result.push_back(walk.truth[static_cast<std::size_t>(scan - walk.scans.begin())] *
                     piece.T_piece_lidar.inverse());
  }
  return result;
}

std::size_t taken_between(const WalkMapper& mapper) {
  const std::vector<std::size_t> stretches = stretches_of(mapper.pieces());
  return static_cast<std::size_t>(
      std::count_if(mapper.loops().begin(), mapper.loops().end(), [&](const Loop& loop) {
        return loop.check.verdict == LoopVerdict::taken &&
               stretches[loop.place] != stretches[loop.query];
      }));
}

std::size_t compared_between(const WalkMapper& mapper, LoopVerdict verdict) {
  const std::vector<std::size_t> stretches = stretches_of(mapper.pieces());
  return static_cast<std::size_t>(
      std::count_if(mapper.loops().begin(), mapper.loops().end(), [&](const Loop& loop) {
        return loop.check.verdict == verdict && stretches[loop.place] != stretches[loop.query];
      }));
}

double worst_between(const WalkMapper& mapper, const std::vector<Pose>& truth) {
  double worst = 0.0;
  const std::vector<Pose>& poses = mapper.graph().poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose gap =
        (truth.front().inverse() * truth[i]).inverse() * (poses.front().inverse() * poses[i]);
    worst = std::max(worst, gap.translation.norm());
  }
  return worst;
}

class Stretches : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_solver()) GTEST_SKIP() << "built without Ceres";
  }
};

TEST(StretchNumbers, CountTheBeginnings) {
  std::vector<Piece> pieces(5);
  EXPECT_EQ(stretches_of(pieces), (std::vector<std::size_t>{0, 0, 0, 0, 0}));
  pieces[0].restarted = pieces[2].restarted = pieces[3].restarted = true;
  EXPECT_EQ(stretches_of(pieces), (std::vector<std::size_t>{0, 0, 1, 2, 2}));
  EXPECT_TRUE(stretches_of({}).empty());
}

/// A lap of a campus and half of the next, lost in between: the second half is put where it lies.
TEST_F(Stretches, OfACampusAreJoinedWhereTheyLie) {
  WalkOptions options;
  options.length = 170.0;
  SceneWalk walk = test::walk_through("campus", 46, options);
  const std::size_t lost = 440;  // of 680
  begin_anew(walk, lost, 4 * kScan);
  const WalkMapper mapper = mapped(walk);
  EXPECT_GE(taken_between(mapper), 2U);
  EXPECT_LT(worst_between(mapper, true_pieces(walk, mapper)), 0.15);
}

/// The same, after which the sensor's clock was set back: no time runs backwards for that, and what
/// was measured is put where it belongs on both sides.
TEST_F(Stretches, AreJoinedWhereTheClockWasSetBack) {
  WalkOptions options;
  options.length = 170.0;
  SceneWalk walk = test::walk_through("campus", 46, options);
  begin_anew(walk, 440, -1000 * kScan);
  const WalkMapper mapper = mapped(walk);
  EXPECT_GE(taken_between(mapper), 2U);
  EXPECT_LT(worst_between(mapper, true_pieces(walk, mapper)), 0.15);
  Trajectory measured;
  for (const PlacedScan& scan : walk.scans) {
    measured.push_back({scan.stamp_ns, scan.T_world_lidar});
  }
  const Trajectory corrected = FinishedWalk(mapper).corrected(measured);
  ASSERT_EQ(corrected.size(), walk.truth.size());
  const Pose T_truth_map = walk.truth[0] * corrected[0].pose.inverse();
  for (std::size_t i = 0; i < corrected.size(); ++i) {
    const Pose found = T_truth_map * corrected[i].pose;
    EXPECT_EQ(corrected[i].stamp_ns, walk.scans[i].stamp_ns);
    ASSERT_LT((found.translation - walk.truth[i].translation).norm(), 0.2) << i;
  }
}

/// The same, but there was no time to walk to where it is said to be known again.
TEST_F(Stretches, ThatCannotHaveBeenReachedStayApart) {
  WalkOptions options;
  options.length = 30.0;
  SceneWalk walk = test::walk_through("campus", 46, options);
  const SceneWalk again = walk;
  const std::size_t first = walk.scans.size();
  for (std::size_t i = 0; i < again.scans.size(); ++i) {
    walk.scans.push_back(again.scans[i]);
    walk.scans.back().stamp_ns += static_cast<std::int64_t>(first) * kScan;
    walk.points.push_back(again.points[i]);
    walk.truth.push_back(again.truth[i]);
  }
  SceneWalk late = walk;
  begin_anew(walk, first, 0);
  const WalkMapper hasty = mapped(walk);
  EXPECT_EQ(taken_between(hasty), 0U);
  EXPECT_GE(compared_between(hasty, LoopVerdict::not_joined), 2U);
  begin_anew(late, first, 400 * kScan);
  EXPECT_GE(taken_between(mapped(late)), 2U) << "with time to walk there it is the same place";
}

/// Where it has been one storey may look like the other, and nothing tells which one this is.
TEST_F(Stretches, UnderARoofAreNotJoined) {
  WalkOptions options;
  options.length = 110.0;
  SceneWalk walk = test::walk_through("storeys", 43, options);
  begin_anew(walk, 180, 4 * kScan);
  const WalkMapper mapper = mapped(walk);
  EXPECT_EQ(taken_between(mapper), 0U);
  EXPECT_GE(compared_between(mapper, LoopVerdict::other_storey), 1U);
}

}  // namespace
}  // namespace surefoot::mapping
