// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Correspondences of Algorithm 1, line 16: exact nearest neighbours at every iteration, although a
// search is made only where the last one no longer tells.
#include <gtest/gtest.h>

#include <functional>

#include "methods/paper/registration.hpp"
#include "registration_fixture.hpp"

namespace surefoot {
namespace {

const Pose kTruePose{so3_exp({0.0, 0.0, 0.4}), {1.0, -0.5, 0.2}};
const Twist kFarOffset = (Twist() << 0.35, -0.25, 0.15, 0.02, -0.03, 0.06).finished();

struct ReuseScene {
  PaperParameters config = test::step_config();
  LocalMap map;
  std::vector<Eigen::Vector3d> points;  // the map's
  Pose T_true;

  explicit ReuseScene(const std::function<void(PaperParameters&)>& set,
                      const Eigen::Vector3d& shift = Eigen::Vector3d::Zero())
      : config(configure(set)),
        map(test::make_map(test::room_points(1, 1500), config, shift)),
        points(map.points()),
        T_true{kTruePose.rotation, kTruePose.translation + shift} {}

  static PaperParameters configure(const std::function<void(PaperParameters&)>& set) {
    PaperParameters config = test::step_config();
    config.registration.convergence = 0.0;  // every iteration asked for is made
    set(config);
    return config;
  }

  /// Pose and source after so many iterations.
  std::pair<Pose, Source> run(int iterations) {
    config.registration.max_iterations = iterations;
    Source source = test::make_source(test::room_points(2, 60), kTruePose);
    const Registration result = register_scan(source, map, apply_update(T_true, kFarOffset), config,
                                              test::kMinMatches, Workers(1), [](Step) {});
    EXPECT_EQ(result.horizontal.iterations, iterations);
    return {result.T_map_lidar, std::move(source)};
  }
};

/// What was found at a pose, against all points of the map.
struct Tally {
  int matched = 0;
  int unmatched = 0;
  int reused = 0;  ///< answers to a search that was made elsewhere
};

void compare(const Source& source, const std::vector<Eigen::Vector3d>& points, const Pose& T,
             double max_distance, Tally& tally) {
  constexpr double kRounding = 2e-6;  // [m] floats within a few metres
  Source expected = {source.points, {}, {}, {}};
  test::match_by_brute_force(expected, points, T, 10.0);
  for (std::size_t i = 0; i < source.points.size(); ++i) {
    const Eigen::Vector3d place = T * source.points[i].cast<double>();
    const double nearest = (expected.matches[i].target - place).norm();
    const Match& match = source.matches[i];
    if (std::abs(nearest - max_distance) < kRounding) continue;  // either answer is right
    ASSERT_EQ(match.found, nearest < max_distance) << nearest;
    tally.reused += source.searches[i].place == place ? 0 : 1;
    (match.found ? tally.matched : tally.unmatched) += 1;
    if (!match.found) continue;
    ASSERT_NEAR((match.target - place).norm(), nearest, kRounding);
    // The very point, unless two are equally near.
    double next = 10.0;
    for (const Eigen::Vector3d& point : points) {
      next = std::min(next, (point - match.target).norm());
    }
    ASSERT_LT(next, kRounding);
  }
}

/// Matches of the iteration after so many, for many a number of them.
Tally expect_exact_matches(ReuseScene scene) {
  Tally tally;
  for (const int iterations : {1, 2, 3, 4, 6, 9, 14, 22, 35}) {
    const Pose before = scene.run(iterations).first;
    const Source after = scene.run(iterations + 1).second;
    const PaperParameters::Registration& config = scene.config.registration;
    const bool early = iterations + 1 <= config.early_iterations;
    compare(after, scene.points, before, early ? config.relaxed_distance : config.max_distance,
            tally);
    if (testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << "after " << iterations << " iterations";
      break;
    }
  }
  return tally;
}

TEST(SearchReuse, MatchesAreTheNearestPointsAtEveryIteration) {
  const Tally tally = expect_exact_matches(ReuseScene([](PaperParameters&) {}));
  EXPECT_GT(tally.matched, 3000);
  EXPECT_GT(tally.reused, 1000) << "the test should hold answers that were kept";
}

TEST(SearchReuse, PointsWithoutAMatchStayWithoutOneJustAsLongAsTheyShould) {
  const Tally tally = expect_exact_matches(ReuseScene([](PaperParameters& config) {
    config.registration.max_distance = 0.12;  // less than the spacing of the map's points
    config.registration.relaxed_distance = 0.3;
  }));
  EXPECT_GT(tally.matched, 500);
  EXPECT_GT(tally.unmatched, 500);
  EXPECT_GT(tally.reused, 1000);
}

TEST(SearchReuse, LongMovesAndShortOnesAlike) {
  // Early iterations reach far; the vertical trust region makes a long way of many short moves.
  const Tally tally = expect_exact_matches(ReuseScene([](PaperParameters& config) {
    config.registration.early_iterations = 10;
    config.registration.relaxed_distance = 3.0;
    config.vertical.trust_region = 0.004;
    config.vertical.sub_iterations = 1;
  }));
  EXPECT_GT(tally.matched, 3000);
  EXPECT_GT(tally.reused, 1000);
}

TEST(SearchReuse, TenKilometresAway) {
  const Tally tally =
      expect_exact_matches(ReuseScene([](PaperParameters&) {}, {10'000.3, -10'000.7, 500.1}));
  EXPECT_GT(tally.matched, 3000);
  EXPECT_GT(tally.reused, 1000);
}

TEST(SearchReuse, ASourceThatWasUsedBeforeBringsNothingAlong) {
  // Registered to one map, then to another: nothing that was known of the first may remain.
  ReuseScene scene([](PaperParameters&) {}), other([](PaperParameters&) {}, {0.31, 0.17, 0.05});
  scene.run(1);
  Source source = test::make_source(test::room_points(2, 60), kTruePose);
  const auto register_to = [&](ReuseScene& to) {
    return register_scan(source, to.map, apply_update(kTruePose, kFarOffset), to.config,
                         test::kMinMatches, Workers(1), [](Step) {});
  };
  (void)register_to(other);
  const Pose again = register_to(scene).T_map_lidar;
  EXPECT_EQ(again.translation, scene.run(1).first.translation);
}

}  // namespace
}  // namespace surefoot
