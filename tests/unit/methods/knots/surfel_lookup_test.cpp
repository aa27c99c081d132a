// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel_lookup.hpp"

#include <gtest/gtest.h>

#include "support/synthetic_run.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: clouds and scenes of the test support

/// The hall seen from some places, a wall hit from both sides, and shrubs.
SurfelMap map_of_much() {
  const Config config;
  SurfelMap map(config.knots, config.map.radius);
  for (const double x : {-5.0, -3.0, -1.0}) {
    const Pose pose{Eigen::Quaterniond::Identity(), {x, 0.5, 0.45}};
    Points points;
    for (const Scan& scan : take_scans(furnished_hall(), standing(pose), 1)) {
      for (const Eigen::Vector3f& point : scan.points) {
        points.push_back(pose * point.cast<double>());
      }
    }
    map.insert({pose.translation, points});
  }
  Random random(3);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d half(0.0, 0.5, 0.5);
  map.insert({{16.0, 0.5, 0.5}, cloud(random, 400, {20.3, 0.5, 0.5}, axes, half, 0.002)});
  map.insert({{24.0, 0.5, 0.5}, cloud(random, 400, {20.5, 0.5, 0.5}, axes, half, 0.002)});
  map.insert({{16.0, 4.0, 0.5}, cloud(random, 400, {20.3, 4.5, 0.5}, axes, {0.7, 0.7, 0.7})});
  return map;
}

TEST(SurfelLookup, AnswersAsTheMapDoes) {
  const SurfelMap map = map_of_much();
  Random random(11);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-7.0, -4.0, -1.0), Eigen::Vector3d(21.0, 6.0, 2.0));
  for (const int finest : {1, 3}) {
    const SurfelLookup lookup(map, finest, box);
    int planes = 0, clouds = 0, backs = 0, outside = 0, none = 0;
    for (int i = 0; i < 40000; ++i) {
      const bool near_wall = i % 4 == 0;
      const Eigen::Vector3d place =
          near_wall ? Eigen::Vector3d(random.uniform(19.8, 21.2), random.uniform(-0.2, 5.4),
                                      random.uniform(-0.2, 1.2))
                    : Eigen::Vector3d(random.uniform(-9.0, 23.0), random.uniform(-6.0, 8.0),
                                      random.uniform(-2.0, 4.0));
      const Eigen::Vector3d ray(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                random.uniform(-1.0, 1.0));
      const Surfel* const expected = map.find(place, ray, finest);
      ASSERT_EQ(lookup.find(place, ray), expected) << place.transpose() << ", " << ray.transpose();
      if (expected == nullptr) {
        ++none;
        continue;
      }
      ++(expected->cloud() ? clouds : planes);
      if (map.find(place, -ray, finest) != expected) ++backs;
      if (!box.contains(place)) ++outside;
    }
    // Every kind of answer was asked for.
    for (const int asked : {planes, clouds, backs, outside, none}) EXPECT_GT(asked, 100) << finest;
  }
}

// As of points that are garbage: no array is made of where there is nothing.
TEST(SurfelLookup, ABoxMayBeFarLargerThanTheMap) {
  const SurfelMap map = map_of_much();
  const Eigen::Vector3d far(1e6, 1e6, 1e5);
  const SurfelLookup lookup(map, 2, Eigen::AlignedBox3d(-far, far));
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d place = 20.0 * random.vector(1.0), ray = random.vector(1.0);
    EXPECT_EQ(lookup.find(place, ray), map.find(place, ray, 2));
  }
}

// Two walls 8 km apart are too far apart for one array: the map answers about them.
TEST(SurfelLookup, AMapMayReachForKilometres) {
  Random random(7);
  SurfelMap map(knots_config(), 1e5);
  Points points;
  for (const double at : {-3000.0, 3000.0}) {
    const Points wall = cloud(random, 60, {at + 0.1, at + 0.2, 0.1 * at + 0.2},
                              Eigen::Matrix3d::Identity(), {0.0, 0.19, 0.19}, 0.002);
    points.insert(points.end(), wall.begin(), wall.end());
  }
  map.insert({{0.0, 0.0, 0.0}, points});
  const Eigen::Vector3d far(4e3, 4e3, 4e3);
  const SurfelLookup lookup(map, 0, Eigen::AlignedBox3d(-far, far));
  for (const double at : {-3000.0, 3000.0}) {
    const Eigen::Vector3d place(at + 0.1, at + 0.2, 0.1 * at + 0.2);
    ASSERT_NE(map.find(place, place, 0), nullptr);
    EXPECT_EQ(lookup.find(place, place), map.find(place, place, 0));
  }
}

TEST(SurfelLookup, OfAnEmptyMapNothingIsFound) {
  const SurfelMap map(Config().knots, 100.0);
  const Eigen::AlignedBox3d box(Eigen::Vector3d::Zero().eval(), Eigen::Vector3d::Ones().eval());
  const SurfelLookup lookup(map, 2, box);
  EXPECT_EQ(lookup.find({0.5, 0.5, 0.5}, {1.0, 0.0, 0.0}), nullptr);
  EXPECT_EQ(lookup.find({5.0, 0.5, 0.5}, {1.0, 0.0, 0.0}), nullptr);
}

}  // namespace
}  // namespace surefoot
