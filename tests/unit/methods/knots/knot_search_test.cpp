// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "geometry/so3.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

const Pose kMapped{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

std::vector<Eigen::Vector3d> points_from(const Pose& pose,
                                         const test::Scene& scene = test::furnished_hall()) {
  const std::vector<Scan> scans = test::take_scans(scene, test::standing(pose), 1);
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : scans.front().points) points.push_back(point.cast<double>());
  return points;
}

SurfelMap map_of_the_hall() {
  const Config config;
  SurfelMap map(config.knots, config.map.radius);
  for (const double x : {-5.0, -3.0, -1.0}) {
    const Pose pose{Eigen::Quaterniond::Identity(), {x, 0.5, 0.45}};
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : points_from(pose)) points.push_back(pose * point);
    map.insert({pose.translation, points});
  }
  return map;
}

/// A way that has been where the map was made.
WalkedWay level_way() {
  WalkedWay way;
  way.add(kMapped);
  return way;
}

std::vector<Eigen::Vector3d> thinned(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < points.size(); i += points.size() / 150) some.push_back(points[i]);
  return some;
}

TEST(KnotSearch, FindsWhereAScanWasTaken) {
  const SurfelMap map = map_of_the_hall();
  const Pose truth{so3_exp({0.0, 0.0, 0.7}), {-2.3, -0.4, 0.45}};
  const SearchRegion region{kMapped, 4.0, 1.5};
  for (const int threads : {1, 2}) {
    const auto places = search_places(map, thinned(points_from(truth)), region, level_way(), 4,
                                      kThorough, Workers(threads));
    ASSERT_FALSE(places.empty());
    EXPECT_TRUE(same_place(places.front().pose, truth))
        << places.front().pose.translation.transpose() << ", fit " << places.front().fit;
    for (std::size_t i = 1; i < places.size(); ++i) {
      EXPECT_LE(places[i].fit, places[i - 1].fit);
      EXPECT_FALSE(same_place(places[i].pose, places[0].pose));
    }
  }
}

// [K29], at the finest step: every second point, each once.
TEST(KnotSearch, TheFitIsTheMeanOverThePoints) {
  const SurfelMap map = map_of_the_hall();
  const Pose truth{so3_exp({0.0, 0.0, 0.7}), {-2.3, -0.4, 0.45}};
  const auto points = thinned(points_from(truth));
  const auto places =
      search_places(map, points, {kMapped, 4.0, 1.5}, level_way(), 4, kThorough, Workers(1));
  ASSERT_GE(places.size(), 2U);
  const double g = 0.35 * 0.7 * 0.7;
  for (const PlaceFit& place : places) {
    double sum = 0.0;
    int asked = 0;
    for (std::size_t i = 0; i < points.size(); i += 2, ++asked) {
      const Eigen::Vector3d ray = place.pose.rotation * points[i];
      const Eigen::Vector3d end = place.pose.translation + ray;
      const Surfel* const surfel = map.find(end, ray, map.level_of(0.25));
      for (int d = 0; surfel != nullptr && d < surfel->directions; ++d) {
        const double r = surfel->across(d).dot(end - surfel->mean);
        sum += 1.0 / (1.0 + r * r / (g * g + surfel->variance(d))) / surfel->directions;
      }
    }
    EXPECT_NEAR(place.fit, sum / asked, 1e-9);
  }
}

// Who was carried up a slope stands higher, and tilted.
TEST(KnotSearch, FindsWhoStandsOnAnotherSlope) {
  const SurfelMap map = map_of_the_hall();
  const Pose truth{so3_exp({0.0, -0.15, 0.0}), {-2.3, 0.3, 1.3}};
  WalkedWay up_there = level_way();
  up_there.add({truth.rotation, {-2.0, 0.5, 0.9}});
  const SearchRegion region{kMapped, 4.0, 0.5};
  const auto points = thinned(points_from(truth));
  const auto places = search_places(map, points, region, up_there, 4, kThorough, Workers(1));
  ASSERT_FALSE(places.empty());
  EXPECT_TRUE(same_place(places.front().pose, truth))
      << places.front().pose.translation.transpose();
  // How much higher is what the way told, about: walls alone do not tell it.
  EXPECT_NEAR(places.front().pose.translation.z(), 1.3, 0.6);
}

// Who stands on stones, or was put down on a bank beside the way.
TEST(KnotSearch, FindsWhoStandsMoreTiltedThanTheWay) {
  const SurfelMap map = map_of_the_hall();
  for (const double roll : {-0.26, 0.26}) {
    for (const double pitch : {-0.17, 0.17}) {
      const Pose truth{so3_exp({0.0, 0.0, 0.7}) * so3_exp({roll, pitch, 0.0}), {-2.3, -0.4, 0.45}};
      const auto points = thinned(points_from(truth));
      const auto places =
          search_places(map, points, {kMapped, 4.0, 1.5}, level_way(), 4, kThorough, Workers(1));
      EXPECT_TRUE(std::any_of(places.begin(), places.end(),
                              [&](const PlaceFit& place) {
                                return same_place(place.pose, truth) &&
                                       place.pose.rotation.angularDistance(truth.rotation) < 0.15;
                              }))
          << roll << ", " << pitch;
    }
  }
}

/// A room [carrier's frame of who stands in its middle], with so many things in it.
void add_room(const Pose& T_world_room, int things, test::Scene& scene) {
  const auto add = [&](double x, double y, const Eigen::Vector3d& half) {
    scene.add({T_world_room * Pose{Eigen::Quaterniond::Identity(), {x, y, half.z() - 0.45}}, half});
  };
  add(0.0, 0.0, {9.0, 7.0, 3.0});
  for (int i = 0; i < things; ++i) add(1.8 * i - 7.0, 4.0 - 8.0 * (i % 2), {0.4, 0.5, 1.0});
}

// Between the steps of the first grid a scan fits less well where it was taken than, on a step,
// where only most of what it sees is.
TEST(KnotSearch, FindsWhoIsTurnedBetweenTheStepsOfTheGrid) {
  constexpr double kHalfStep = std::numbers::pi / 30.0;
  const Pose truth{so3_exp({0.0, 0.0, kHalfStep}), {-12.0, 0.0, 0.45}};
  const Pose other{so3_exp({0.0, 0.0, 2.0 * kHalfStep}), {12.0, 0.0, 0.45}};
  const Pose room{so3_exp({0.0, 0.0, 0.3}), Eigen::Vector3d::Zero()};
  test::Scene scene;
  add_room(truth * room, 8, scene);
  add_room(other * room, 4, scene);
  const Config config;
  SurfelMap map(config.knots, config.map.radius);
  WalkedWay way;
  for (const Pose& pose : {truth, other}) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& point : points_from(pose, scene)) points.push_back(pose * point);
    map.insert({pose.translation, points});
    way.add(pose);
  }
  const SearchRegion region{{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.45}}, 13.0, 1.0};
  const auto places =
      search_places(map, thinned(points_from(truth, scene)), region, way, 1, {true, 1}, Workers(1));
  EXPECT_TRUE(same_place(places.front().pose, truth))
      << places.front().pose.translation.transpose();
}

// A hall over the hall looks like it; who may not be on another storey is looked for on his own.
TEST(KnotSearch, KeepsToItsStoreyIfItHasTo) {
  const SurfelMap map = map_of_the_hall();
  const auto points = thinned(points_from(kMapped));
  Pose above = kMapped;
  above.translation.z() += 3.0;
  WalkedWay way = level_way();
  way.add(above);
  SearchRegion region{above, 2.0, 0.2};
  auto places = search_places(map, points, region, way, 4, kThorough, Workers(1));
  ASSERT_FALSE(places.empty());
  EXPECT_TRUE(same_place(places.front().pose, kMapped));
  region.below = region.above = 1.5;
  places = search_places(map, points, region, way, 4, kThorough, Workers(1));
  ASSERT_FALSE(places.empty());
  for (const PlaceFit& place : places) EXPECT_GT(place.pose.translation.z(), 1.5);
}

// Nor is he looked for higher and lower than that about the ground of the way.
TEST(KnotSearch, KeepsToItsStoreyAboutTheWayToo) {
  const SurfelMap map = map_of_the_hall();
  Pose higher = kMapped;
  higher.translation.z() += 0.6;
  SearchRegion region{kMapped, 2.0, 0.2};
  const auto points = thinned(points_from(higher));
  const auto best = [&] {
    return search_places(map, points, region, level_way(), 4, kThorough, Workers(1))
        .front()
        .pose.translation;
  };
  EXPECT_GT(best().z(), kMapped.translation.z() + 0.3);
  region.below = region.above = 0.3;
  EXPECT_TRUE(region.is_as_high(best()));
}

// Who climbs is not found where he came from, however near to half a storey.
TEST(KnotSearch, ARegionMayEndNearerBelowThanAbove) {
  SearchRegion region{kMapped, 2.0, 0.2};
  const auto is_as_high = [&](double higher) {
    return region.is_as_high(kMapped.translation + Eigen::Vector3d(1.0, 0.0, higher));
  };
  EXPECT_TRUE(is_as_high(-100.0));
  EXPECT_TRUE(is_as_high(100.0));
  region.below = 0.5;
  region.above = 1.5;
  EXPECT_FALSE(is_as_high(-0.6));
  EXPECT_TRUE(is_as_high(-0.4));
  EXPECT_TRUE(is_as_high(1.4));
  EXPECT_FALSE(is_as_high(1.6));
}

// Up and down alike: what lies behind is shut out by half of what lies ahead.
TEST(KnotSearch, WhoClimbsAndWhoGoesDownAreNotFoundWhereTheyCameFrom) {
  const auto heights = [](double climb) {
    SearchRegion region{kMapped, 2.0, 0.2};
    region.keep_to_storey(climb);
    return std::pair(region.below, region.above);
  };
  const auto [level_below, level_above] = heights(0.0);
  EXPECT_EQ(level_below, level_above);
  EXPECT_LT(level_above, 2.0) << "storeys are 2.5 m high and more";
  EXPECT_EQ(heights(1.0), std::pair(level_below / 2.0, level_above));
  EXPECT_EQ(heights(-1.0), std::pair(level_below, level_above / 2.0));
}

TEST(KnotSearch, LooksNoFartherThanItsRegion) {
  const SurfelMap map = map_of_the_hall();
  const Pose truth{so3_exp({0.0, 0.0, 0.7}), {-2.3, -0.4, 0.45}};
  const auto places = search_places(map, thinned(points_from(truth)), {kMapped, 1.0, 0.2},
                                    level_way(), 4, kThorough, Workers(1));
  ASSERT_FALSE(places.empty());
  for (const PlaceFit& place : places) {
    EXPECT_LT((place.pose.translation - kMapped.translation).norm(), 2.5);
    EXPECT_LT(place.pose.rotation.angularDistance(kMapped.rotation), 0.5);
  }
}

TEST(KnotSearch, ItsRegionIsRound) {
  const SurfelMap map = map_of_the_hall();
  const Pose truth{Eigen::Quaterniond::Identity(), {-2.0, 0.0, 0.45}};
  Pose centre = truth;
  centre.translation += Eigen::Vector3d(-3.8, -3.8, 0.0);
  const auto places = search_places(map, thinned(points_from(truth)), {centre, 4.0, 0.2},
                                    level_way(), 4, kThorough, Workers(1));
  for (const PlaceFit& place : places) EXPECT_FALSE(same_place(place.pose, truth));
}

TEST(KnotSearch, PointsOfNowhereFitNowhere) {
  const SurfelMap map = map_of_the_hall();
  std::vector<Eigen::Vector3d> far = thinned(points_from(kMapped));
  for (Eigen::Vector3d& point : far) point *= 50.0;
  for (const PlaceFit& place :
       search_places(map, far, {kMapped, 2.0, 0.3}, level_way(), 4, kThorough, Workers(1))) {
    EXPECT_LT(place.fit, 0.05);
  }
}

}  // namespace
}  // namespace surefoot
