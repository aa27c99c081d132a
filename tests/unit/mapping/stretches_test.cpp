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
#include "mapping/drift_model.hpp"
#include "mapping/finished_walk.hpp"
#include "mapping/held_pieces.hpp"
#include "mapping/placed_scans.hpp"
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
    walk.scans[i].frame = 1;
    walk.scans[i].T_world_lidar = T_new_old * walk.scans[i].T_world_lidar;
    walk.scans[i].stamp_ns += pause_ns;
  }
}

/// From `away` on it is in another frame, from `home` on in the first one again, where it has gone
/// on by `carried` more than it knows.
void come_home(SceneWalk& walk, std::size_t away, std::size_t home, const Pose& carried = {}) {
  const Pose T_new_old = se3_exp((Twist() << 12.0, -7.0, 1.5, 0.0, 0.0, 0.9).finished());
  walk.scans[away].restarted = walk.scans[home].restarted = true;
  for (std::size_t i = away; i < walk.scans.size(); ++i) {
    const Pose& T_new_world = i < home ? T_new_old : carried;
    walk.scans[i].frame = i < home ? 1 : 0;
    walk.scans[i].T_world_lidar = T_new_world * walk.scans[i].T_world_lidar;
  }
}

/// A lap of a campus and half of the next, walked once for all tests.
const SceneWalk& lap_and_a_half() {
  static const SceneWalk walk = [] {
    WalkOptions options;
    options.length = 170.0;
    return test::walk_through("campus", 46, options);
  }();
  return walk;
}

/// 30 m of a campus, and at once from their begin again.
SceneWalk the_same_way_twice() {
  WalkOptions options;
  options.length = 30.0;
  SceneWalk walk = test::walk_through("campus", 46, options);
  const SceneWalk again = walk;
  const auto first = static_cast<std::int64_t>(walk.scans.size());
  for (std::size_t i = 0; i < again.scans.size(); ++i) {
    walk.scans.push_back(again.scans[i]);
    walk.scans.back().stamp_ns += first * kScan;
    walk.points.push_back(again.points[i]);
    walk.truth.push_back(again.truth[i]);
  }
  return walk;
}

WalkMapper mapped(const SceneWalk& walk, bool close_loops = true) {
  MapperOptions options;
  options.close_loops = close_loops;
  WalkMapper mapper{options};
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

/// [m] How far the last piece is from where it should be against the first.
double apart_at_the_end(const SceneWalk& walk, const WalkMapper& mapper,
                        const std::vector<Pose>& poses) {
  const std::vector<Pose> truth = true_pieces(walk, mapper);
  const Pose gap =
      (truth.front().inverse() * truth.back()).inverse() * (poses.front().inverse() * poses.back());
  return gap.translation.norm();
}

/// Whether the first piece and the last one are held together.
bool is_whole(const WalkMapper& mapper) {
  HeldPieces held(mapper.graph());
  return held.set_of(0) == held.set_of(mapper.pieces().size() - 1);
}

TEST(PlacedScans, AreInTheFrameOfTheirSegmentUntilAMapBeginsUnderItsNumber) {
  PlacedScans placed;
  std::vector<int> frames, restarts;
  const auto add = [&](Status status, int segment) {
    Estimate estimate;
    estimate.status = status;
    estimate.segment = segment;
    const PlacedScan scan = placed.next(estimate);
    frames.push_back(scan.frame);
    restarts.push_back(scan.restarted ? 1 : 0);
  };
  add(Status::first_scan, 0);
  add(Status::ok, 0);
  add(Status::first_scan, 1);
  add(Status::ok, 1);
  add(Status::ok, 0);  // home
  add(Status::ok, 0);
  add(Status::first_scan, 0);  // of an odometry that does not count
  add(Status::ok, 0);
  EXPECT_EQ(frames, (std::vector<int>{0, 0, 1, 1, 0, 0, 2, 2}));
  EXPECT_EQ(restarts, (std::vector<int>{0, 0, 1, 0, 1, 0, 1, 0}));
}

TEST(Homecomings, LeadFromTheNearestPieceOfTheFrameThatWasLeft) {
  std::vector<Piece> pieces(6);
  const double places[] = {0.0, 5.0, 10.0, 5.5, 6.0, 9.0};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].T_world_piece.translation.x() = places[i];
    pieces[i].frame = i == 3 ? 1 : 0;
    pieces[i].covariance = 1e-6 * Matrix6::Identity();
  }
  pieces[3].restarted = pieces[4].restarted = true;
  const std::vector<PoseEdge> homes = homecomings(pieces, {});
  ASSERT_EQ(homes.size(), 1U);
  EXPECT_EQ(homes[0].from, 1U);
  EXPECT_EQ(homes[0].to, 4U);
  EXPECT_FALSE(homes[0].inlier);
  EXPECT_NEAR(homes[0].T_from_to.translation.x(), 1.0, 1e-12);
  // A metre's odometry: 0.01 m of walk, 0.005 m however short, 0.001 m all along.
  const double variance = 1e-6 + 0.01 * 0.01 + 0.005 * 0.005 + 0.001 * 0.001;
  EXPECT_NEAR(homes[0].information(0, 0) * variance, 1.0, 1e-6);
  pieces[4].frame = 2;
  EXPECT_TRUE(homecomings(pieces, {}).empty()) << "nobody was there before";
}

/// What an odometry has told of a walk.
Trajectory measured(const SceneWalk& walk) {
  Trajectory poses;
  for (const PlacedScan& scan : walk.scans) poses.push_back({scan.stamp_ns, scan.T_world_lidar});
  return poses;
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
  SceneWalk walk = lap_and_a_half();
  const std::size_t lost = 440;  // of 680
  begin_anew(walk, lost, 4 * kScan);
  const WalkMapper mapper = mapped(walk);
  EXPECT_GE(taken_between(mapper), 2U);
  EXPECT_LT(worst_between(mapper, true_pieces(walk, mapper)), 0.15);
}

/// The same, after which the sensor's clock was set back: no time runs backwards for that, and what
/// was measured is put where it belongs on both sides.
TEST_F(Stretches, AreJoinedWhereTheClockWasSetBack) {
  SceneWalk walk = lap_and_a_half();
  begin_anew(walk, 440, -1000 * kScan);
  const WalkMapper mapper = mapped(walk);
  EXPECT_GE(taken_between(mapper), 2U);
  EXPECT_LT(worst_between(mapper, true_pieces(walk, mapper)), 0.15);
  const std::vector<FramePoses> frames = FinishedWalk(mapper).corrected(measured(walk));
  ASSERT_EQ(frames.size(), 1U) << "what is joined has one frame";
  const Trajectory& corrected = frames[0].poses;
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
  SceneWalk walk = the_same_way_twice();
  const std::size_t first = walk.scans.size() / 2;
  SceneWalk late = walk;
  begin_anew(walk, first, 0);
  const WalkMapper hasty = mapped(walk);
  EXPECT_EQ(taken_between(hasty), 0U);
  EXPECT_GE(compared_between(hasty, LoopVerdict::not_joined), 2U);
  const std::vector<FramePoses> frames = FinishedWalk(hasty).corrected(measured(walk));
  ASSERT_EQ(frames.size(), 2U) << "each stretch has its own";
  EXPECT_EQ(frames[0].frame, 0U);
  EXPECT_EQ(frames[0].poses.size(), first);
  EXPECT_EQ(frames[1].frame, 1U);
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

/// Four stretches: a way's first part, another place, the way's last part, which shares nothing
/// with the first, and the whole way. What the last one joins to the first is held against the
/// others.
TEST_F(Stretches, ThatWereJoinedAreComparedWithEachThatWaits) {
  SceneWalk walk;
  const auto append = [&](const SceneWalk& part) {
    const int frame = walk.scans.empty() ? 0 : walk.scans.back().frame + 1;
    const std::int64_t begin_ns = walk.scans.empty() ? 0 : walk.scans.back().stamp_ns + 400 * kScan;
    for (std::size_t i = 0; i < part.scans.size(); ++i) {
      walk.scans.push_back(part.scans[i]);
      walk.scans.back().restarted = frame > 0 && i == 0;
      walk.scans.back().frame = frame;
      walk.scans.back().stamp_ns += begin_ns;
    }
    walk.points.insert(walk.points.end(), part.points.begin(), part.points.end());
    walk.truth.insert(walk.truth.end(), part.truth.begin(), part.truth.end());
  };
  const auto campus = [](double from, double length) {
    WalkOptions options;
    options.from = from;
    options.length = length;
    options.unknown_start = true;
    return test::walk_through("campus", 46, options);
  };
  WalkOptions elsewhere;
  elsewhere.length = 10.0;
  append(campus(0.0, 25.0));
  append(test::walk_through("forest", 7, elsewhere));
  append(campus(60.0, 25.0));
  append(campus(0.0, 85.0));
  const WalkMapper mapper = mapped(walk);
  ASSERT_EQ(stretches_of(mapper.pieces()).back(), 3U);
  HeldPieces held(mapper.graph());
  std::vector<bool> whole;
  const std::vector<std::size_t> stretches = stretches_of(mapper.pieces());
  for (std::size_t stretch = 1; stretch <= 3; ++stretch) {
    const auto first = std::find(stretches.begin(), stretches.end(), stretch) - stretches.begin();
    whole.push_back(held.set_of(static_cast<std::size_t>(first)) == held.set_of(0));
  }
  EXPECT_EQ(whole, (std::vector<bool>{false, true, true}));
}

/// Under a roof no loop joins stretches; who came home is known to be there.
TEST_F(Stretches, AreJoinedByTheOdometryThatCameHome) {
  WalkOptions options;
  options.length = 60.0;
  SceneWalk walk = test::walk_through("storeys", 43, options);
  come_home(walk, 120, 180);
  for (const bool close_loops : {true, false}) {
    const WalkMapper mapper = mapped(walk, close_loops);
    EXPECT_TRUE(is_whole(mapper));
    const std::vector<std::size_t> stretches = stretches_of(mapper.pieces());
    EXPECT_EQ(stretches.back(), 2U);
    HeldPieces held(mapper.graph());
    const auto away = std::find(stretches.begin(), stretches.end(), 1U) - stretches.begin();
    EXPECT_NE(held.set_of(0), held.set_of(static_cast<std::size_t>(away)));
    EXPECT_LT(apart_at_the_end(walk, mapper, mapper.graph().poses), 0.05);
  }
}

/// It goes where the loops have put what it came home to.
TEST_F(Stretches, AHomeThatLoopsMoveTakesAlongWhoCameHome) {
  WalkOptions options;
  options.length = 150.0;
  options.yaw_drift = 0.0004;
  SceneWalk walk = test::walk_through("campus", 46, options);
  come_home(walk, 480, 520);
  const WalkMapper mapper = mapped(walk);
  ASSERT_GE(mapper.taken(), 2U);
  ASSERT_TRUE(is_whole(mapper));
  std::vector<Pose> by_odometry;
  for (const Piece& piece : mapper.pieces()) by_odometry.push_back(piece.T_world_piece);
  EXPECT_LT(apart_at_the_end(walk, mapper, mapper.graph().poses),
            0.3 * apart_at_the_end(walk, mapper, by_odometry));
}

/// What was taken for home and is another place does not join; loops do, rightly.
TEST_F(Stretches, AHomecomingThatWhatWasSeenSpeaksAgainstIsNotBelieved) {
  SceneWalk walk = the_same_way_twice();
  const std::size_t first = walk.scans.size() / 2;
  const Pose beside = se3_exp((Twist() << 4.0, 3.0, 0.0, 0.0, 0.0, 0.3).finished());
  come_home(walk, first - 20, first, beside);
  const WalkMapper mapper = mapped(walk);
  ASSERT_TRUE(is_whole(mapper));
  EXPECT_LT(apart_at_the_end(walk, mapper, mapper.graph().poses), 0.15);
}

}  // namespace
}  // namespace surefoot::mapping
