// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a map of surfels keeps, and what it forgets: full voxels, far ones, what moved away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "methods/knots/surfel_map.hpp"
#include "support/random.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using test::cloud;
using test::find;
using test::kCentre;
using test::knots_config;
using test::kSensor;
using test::map_of;
using test::Points;
using test::Random;
using test::remove_all_far;

TEST(SurfelMap, AFullVoxelKeepsWhatItSawFirst) {
  Random random(6);
  Config::Knots config = knots_config();
  config.points_per_voxel = 50;
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  SurfelMap map = map_of(cloud(random, 50, {0.2, 0.2, 0.1}, axes, {0.19, 0.19, 0.0}), config);
  const Surfel before = *find(map, kCentre);
  map.insert({kSensor, cloud(random, 500, {0.2, 0.2, 0.3}, axes, {0.19, 0.19, 0.0})});
  const Surfel after = *find(map, kCentre);
  EXPECT_EQ(after.mean, before.mean);
  EXPECT_EQ(after.variance(0), before.variance(0));
  EXPECT_NEAR(after.mean.z(), 0.1, 1e-6);
}

TEST(SurfelMap, AVoxelTakesAScansPointsInWhateverOrder) {
  Random random(11);
  Config::Knots config = knots_config();
  config.points_per_voxel = 50;
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Points points = cloud(random, 80, {0.2, 0.2, 0.1}, axes, {0.19, 0.19, 0.0}, 0.005);
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const Surfel one = *find(map_of(points, config), kCentre);
  std::reverse(points.begin(), points.end());
  const Surfel other = *find(map_of(points, config), kCentre);
  EXPECT_LT((one.mean - other.mean).norm(), 1e-7);
  EXPECT_NEAR(one.variance(0), other.variance(0), 1e-8);
}

// Single returns of leaves and noise: half of a forest's voxels.
TEST(SurfelMap, WhatHasTooFewPointsIsForgotten) {
  Random random(12);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d few(8.2, 0.2, 0.2), hit_again(4.2, 0.2, 0.2);
  Points points = cloud(random, 60, kCentre, axes, {0.19, 0.19, 0.0});
  points.insert(points.end(), 3, few);
  SurfelMap map = map_of(points);
  const auto holds = [&](const Eigen::Vector3d& place) {
    const std::vector<Eigen::Vector3d> kept = map.points();
    return std::any_of(kept.begin(), kept.end(),
                       [&](const Eigen::Vector3d& point) { return (point - place).norm() < 0.3; });
  };
  for (int scan = 0; scan < 20; ++scan) {
    map.insert({kSensor, {hit_again}});
    remove_all_far(map, kSensor);
  }
  EXPECT_TRUE(holds(few)) << "it may be hit again";
  for (int scan = 0; scan < 20; ++scan) {
    map.insert({kSensor, {hit_again}});
    remove_all_far(map, kSensor);
  }
  EXPECT_FALSE(holds(few));
  EXPECT_TRUE(holds(hit_again));
  EXPECT_TRUE(holds(kCentre)) << "a surfel stays";
}

TEST(SurfelMap, FarVoxelsLeave) {
  Random random(7);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d near(0.2, 0.2, 0.2), far(160.2, 0.2, 0.2);
  Points points = cloud(random, 60, near, axes, {0.19, 0.19, 0.0});
  const Points others = cloud(random, 60, far, axes, {0.19, 0.19, 0.0});
  points.insert(points.end(), others.begin(), others.end());
  SurfelMap map = map_of(points);  // its radius is 100 m
  ASSERT_EQ(map.points().size(), 2U);
  remove_all_far(map, {80.0, 0.0, 0.0});
  EXPECT_EQ(map.points().size(), 2U);
  remove_all_far(map, {100.5, 0.0, 0.0});
  ASSERT_EQ(map.points().size(), 1U);
  EXPECT_NEAR(map.points().front().x(), 160.2, 0.1);
  EXPECT_EQ(find(map, near), nullptr);
  EXPECT_NE(find(map, far), nullptr);  // the table still leads to its voxel
  map.insert({kSensor, cloud(random, 60, near, axes, {0.19, 0.19, 0.0})});
  EXPECT_NE(find(map, near), nullptr);
  map.insert({kSensor, cloud(random, 60, {4.2, 0.2, 0.2}, axes, {0.19, 0.19, 0.0})});
  EXPECT_EQ(map.points().size(), 3U) << "what was dropped is used again, and by one only";
  map.clear();
  EXPECT_TRUE(map.empty());
  EXPECT_EQ(find(map, far), nullptr);
}

TEST(SurfelMap, FarVoxelsLeaveInParts) {
  Random random(8);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  SurfelMap map = map_of(cloud(random, 20'000, {0.0, 0.0, 0.0}, axes, {20.0, 20.0, 0.1}));
  const std::size_t all = map.points().size();
  ASSERT_GT(all, 5'000U);
  const Eigen::Vector3d away(200.0, 0.0, 0.0);
  for (std::size_t call = 1; call <= SurfelMap::kRound; ++call) {
    const std::size_t before = map.points().size();
    map.remove_far(away);
    EXPECT_LE(before - map.points().size(), all / SurfelMap::kRound + 1) << call;
  }
  EXPECT_TRUE(map.empty());
}

TEST(SurfelMap, WhatWasDroppedLeavesItsMemoryForWhatComes) {
  Random random(9);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const auto floor_at = [&](double x) {
    return cloud(random, 2'000, {x, 0.0, 0.0}, axes, {5.0, 5.0, 0.1});
  };
  SurfelMap map = map_of(floor_at(0.0));
  for (int place = 1; place <= 5; ++place) {
    const Eigen::Vector3d sensor(place * 200.0, 0.0, 1.0);
    remove_all_far(map, sensor);
    EXPECT_TRUE(map.empty());
    map.insert({sensor, floor_at(sensor.x())});
    const SurfelMap fresh = map_of(floor_at(sensor.x()), knots_config(), sensor);
    EXPECT_NEAR(static_cast<double>(map.points().size()),
                static_cast<double>(fresh.points().size()),
                0.05 * static_cast<double>(fresh.points().size()));
    for (const Eigen::Vector3d& point : map.points()) {
      ASSERT_LT(std::abs(point.x() - sensor.x()), 6.0);  // nothing is left of what a side held
    }
  }
}

/// Scans of a wall that somebody stands in front of, for so many scans, and then no longer.
class Visitor {
 public:
  explicit Visitor(int gone_after) : map_(config(gone_after), 100.0) {}

  void stand(int scans) { look(scans, true); }
  void leave(int scans) { look(scans, false); }

  /// Points of the map about the place.
  [[nodiscard]] int left() const {
    const Points points = map_.points();
    return static_cast<int>(std::count_if(points.begin(), points.end(), [](const auto& point) {
      return (point - kPlace).norm() < 0.6;
    }));
  }
  /// Whether a surfel about the place answers.
  [[nodiscard]] bool answers() const { return find(map_, kPlace, 0, {0.0, 0.0, 0.6}) != nullptr; }
  [[nodiscard]] int wall() const { return static_cast<int>(map_.points().size()) - left(); }
  [[nodiscard]] const Points& emptied() const { return emptied_; }

 private:
  static Config::Knots config(int gone_after) {
    Config::Knots config = knots_config();
    config.gone_after = gone_after;
    return config;
  }

  void look(int scans, bool standing) {
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    for (int i = 0; i < scans; ++i) {
      Points points = cloud(random_, 4000, {12.0, 0.0, 1.0}, axes, {0.0, 6.0, 2.0}, 0.01);
      if (standing) {
        const Points body = cloud(random_, 200, kPlace, axes, {0.0, 0.2, 0.5}, 0.01);
        points.insert(points.end(), body.begin(), body.end());
      }
      const Points gone = map_.insert({{0.0, 0.0, 0.6}, points}).centres;
      emptied_.insert(emptied_.end(), gone.begin(), gone.end());
    }
  }

  inline static const Eigen::Vector3d kPlace{5.0, 0.0, 1.0};
  Random random_{11};
  SurfelMap map_;
  Points emptied_;
};

TEST(SurfelMap, WhatMovedAwayIsForgotten) {
  Visitor visitor(2);
  visitor.stand(5);
  const int standing = visitor.left(), wall = visitor.wall();
  ASSERT_GE(standing, 6);
  EXPECT_TRUE(visitor.answers());
  EXPECT_TRUE(visitor.emptied().empty());
  visitor.leave(1);
  EXPECT_EQ(visitor.left(), standing);  // one scan is not enough
  visitor.leave(20);
  EXPECT_EQ(visitor.left(), 0);
  EXPECT_FALSE(visitor.answers());
  EXPECT_GE(visitor.wall(), wall);
  EXPECT_EQ(static_cast<int>(visitor.emptied().size()), standing - visitor.left());
  for (const Eigen::Vector3d& centre : visitor.emptied()) {
    EXPECT_LT((centre - Eigen::Vector3d(5.0, 0.0, 1.0)).norm(), 1.0);
    const Eigen::Array3d cells = centre.array() / 0.4 - 0.5;
    EXPECT_LT((cells - cells.round()).abs().maxCoeff(), 1e-9);  // a voxel's centre
  }
  visitor.stand(3);
  EXPECT_GT(visitor.left(), standing / 2);  // who comes back is seen again
}

TEST(SurfelMap, WhatStoodForLongIsForgottenTheLater) {
  for (const int scans : {58, 59, 60}) {  // whoever's turn it is to be asked about
    Visitor visitor(2);
    visitor.stand(scans);
    const int standing = visitor.left();
    visitor.leave(16);  // a quarter of these, and 2, are more
    EXPECT_EQ(visitor.left(), standing) << scans;
    visitor.leave(30);
    EXPECT_EQ(visitor.left(), 0) << scans;
  }
}

TEST(SurfelMap, OfWhatIsHitAgainTheScansCountAnew) {
  Visitor visitor(10);
  visitor.stand(5);
  const int standing = visitor.left();
  for (int time = 0; time < 5; ++time) {
    visitor.leave(8);
    visitor.stand(1);
  }
  EXPECT_GE(visitor.left(), standing);
  EXPECT_TRUE(visitor.emptied().empty());
}

TEST(SurfelMap, NothingIsForgottenIfNotAskedFor) {
  Visitor visitor(0);
  visitor.stand(5);
  const int standing = visitor.left();
  visitor.leave(60);
  EXPECT_EQ(visitor.left(), standing);
  EXPECT_TRUE(visitor.emptied().empty());
}
}  // namespace
}  // namespace surefoot
