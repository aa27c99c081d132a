// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The map that scans enter while the caller goes on: what it answers is what one that is waited for
// answers.
#include "methods/knots/growing_map.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using test::cloud;
using test::Points;
using test::Random;

Config config_of_visits() {
  Config config;
  config.knots = test::knots_config();
  config.knots.gone_after = 2;
  return config;
}

/// A wall, and who stands in front of it for the first five scans.
View visit(Random& random, int scan) {
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Points points = cloud(random, 4000, {12.0, 0.0, 1.0}, axes, {0.0, 6.0, 2.0}, 0.01);
  if (scan < 5) {
    const Points body = cloud(random, 200, {5.0, 0.0, 1.0}, axes, {0.0, 0.2, 0.5}, 0.01);
    points.insert(points.end(), body.begin(), body.end());
  }
  return {{0.0, 0.0, 0.6}, std::move(points)};
}

TEST(GrowingMap, AnswersOnceTheScanIsInAtAnyNumberOfThreads) {
  const Config config = config_of_visits();
  for (const int threads : {1, 2, 3}) {
    const Session session{config, Workers(threads)};
    GrowingMap map(session);
    SurfelMap surfels(config.knots, config.map.radius);
    LastViews views;
    Random random(11);
    std::size_t emptied = 0;
    for (int scan = 0; scan < 25; ++scan) {
      const View view = visit(random, scan);
      map.add(view);
      surfels.remove_far(view.sensor);
      const Cubes gone = surfels.insert(view);
      views.add(view);
      emptied += gone.centres.size();
      switch (scan % 3) {  // whatever is asked first waits
        case 0:
          EXPECT_EQ(map.emptied().centres, gone.centres);
          break;
        case 1:
          EXPECT_EQ(map.surfels().points(), surfels.points());
          break;
        default:
          EXPECT_EQ(map.views().contradiction(view), views.contradiction(view));
      }
      EXPECT_EQ(map.emptied().side, gone.side);
    }
    EXPECT_GT(emptied, 5U);
    EXPECT_EQ(map.surfels().points(), surfels.points());
  }
}

TEST(GrowingMap, WhatWasEmptiedIsToldUntilTheNextScan) {
  const Config config = config_of_visits();
  const Session session{config, Workers(2)};
  GrowingMap map(session);
  Random random(11);
  int scan = 0;
  do {
    ASSERT_LT(scan, 25);
    map.add(visit(random, scan++));
  } while (map.emptied().centres.empty());
  map.forget_emptied();
  EXPECT_TRUE(map.emptied().centres.empty());
}

TEST(GrowingMap, WhatIsFarFromTheNextScansLeaves) {
  const Config config = config_of_visits();
  const Session session{config, Workers(2)};
  GrowingMap map(session);
  Random random(11);
  map.add(visit(random, 0));
  const std::size_t here = map.surfels().points().size();
  const Eigen::Vector3d away(5.0 * config.map.radius, 0.0, 0.0);
  for (std::size_t scan = 0; scan <= SurfelMap::kRound; ++scan) {
    map.add({away, {away + Eigen::Vector3d(1.0, 0.0, 0.0)}});
  }
  ASSERT_GT(here, 10U);
  EXPECT_EQ(map.surfels().points().size(), 1U);
}

TEST(GrowingMap, ClearedItIsAsNew) {
  const Config config = config_of_visits();
  const Session session{config, Workers(2)};
  GrowingMap map(session), fresh(session);
  Random random(11);
  map.add(visit(random, 9));  // beams go through where somebody stands in the next one
  const View view = visit(random, 0);
  EXPECT_GT(map.views().contradiction(view), 0.0);
  map.clear();
  EXPECT_TRUE(map.surfels().empty());
  EXPECT_EQ(map.views().contradiction(view), 0.0);
  map.add(view);
  fresh.add(view);
  EXPECT_EQ(map.surfels().points(), fresh.surfels().points());
}

}  // namespace
}  // namespace surefoot
