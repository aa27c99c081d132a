// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/decompositions.hpp"
#include "support/random.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using test::cloud;
using test::find;
using test::find_again;
using test::kCentre;
using test::knots_config;
using test::kSensor;
using test::level_found;
using test::map_of;
using test::Points;
using test::Random;
using test::remove_all_far;

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(SurfelMap, APlanesMeanNormalAndVarianceAreItsPoints) {
  Random random(1);
  for (const double noise : {0.0, 0.005}) {
    for (int i = 0; i < 20; ++i) {
      const Eigen::Matrix3d axes = random.pose(0.0, 3.0).rotation.toRotationMatrix();
      const Points points = cloud(random, 60, kCentre, axes, {0.1, 0.1, 0.0}, noise);
      const Eigen::Vector3d sensor = kCentre + 5.0 * axes.col(2);
      const SurfelMap map = map_of(points, knots_config(), sensor);
      const Surfel* const surfel = find(map, kCentre, 0, sensor);
      ASSERT_NE(surfel, nullptr);
      ASSERT_EQ(surfel->directions, 1);
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& point : points) mean += point / 60.0;
      Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
      for (const auto& p : points) covariance += (p - mean) * (p - mean).transpose() / 60.0;
      const SymmetricEigen<3> eigen = symmetric_eigen<3>(covariance);
      const Eigen::Vector3d normal = noise > 0.0 ? eigen.vectors.col(0) : axes.col(2);
      // Sums of 60 points within 0.1 m, in single precision.
      EXPECT_LT((surfel->mean - mean).norm(), 1e-8);
      EXPECT_NEAR(surfel->across(0).norm(), 1.0, 1e-7);
      EXPECT_LT(surfel->across(0).cross(normal).norm(), 1e-6);
      EXPECT_NEAR(surfel->variance(0), eigen.values[0], 2e-9);
    }
  }
}

TEST(SurfelMap, AStandingPoleHasTwoDirectionsALyingLineNone) {
  Random random(2);
  for (const double tilt_deg : {0.0, 20.0, 40.0, 50.0, 70.0, 90.0}) {
    const Eigen::Matrix3d axes = so3_exp({tilt_deg * kDegree, 0.0, 0.0}).toRotationMatrix();
    const SurfelMap map = map_of(cloud(random, 60, kCentre, axes, {0.003, 0.003, 0.19}));
    const Surfel* const surfel = find(map, kCentre);
    if (tilt_deg > 45.0) {
      EXPECT_EQ(surfel, nullptr) << tilt_deg;
      continue;
    }
    ASSERT_NE(surfel, nullptr) << tilt_deg;
    ASSERT_EQ(surfel->directions, 2);
    for (const Eigen::Vector3d& across : {surfel->across(0), surfel->across(1)}) {
      EXPECT_LT(std::abs(across.dot(axes.col(2))), 0.02);
      EXPECT_NEAR(across.norm(), 1.0, 1e-7);  // single precision
    }
    EXPECT_LT(std::abs(surfel->across(0).dot(surfel->across(1))), 1e-7);
    EXPECT_LE(surfel->variance(0), surfel->variance(1));
    EXPECT_LT(surfel->variance(1), 0.003 * 0.003);
  }
}

/// Upright strips, far narrower than a voxel: pieces of a wall, and a pole before it.
TEST(SurfelMap, APieceOfAWallIsNoPole) {
  const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
  for (const double before : {0.0, 0.35}) {
    Random random(7);
    const Eigen::Vector3d place(0.2, 0.2, 0.2);
    // Of a wall across y a voxel of the finest grid shows a strip, and the next grid more.
    Points points = cloud(random, 60, place, upright, {0.02, 0.003, 0.19});
    const Points wall = cloud(random, 400, {1.2, 0.2 + before, 0.8}, upright, {0.38, 0.003, 0.7});
    points.insert(points.end(), wall.begin(), wall.end());
    const SurfelMap map = map_of(points);
    const Surfel* const surfel = find(map, place);
    const bool is_pole = surfel != nullptr && surfel->pole();
    EXPECT_EQ(is_pole, before > 0.0) << before;
  }
}

TEST(SurfelMap, OneFiringOnAWallIsNoPole) {
  const Eigen::Vector3d sensor = kCentre + Eigen::Vector3d(6.0, 0.0, 0.5);  // looks along -x
  struct Case {
    double deep, wide;  // half of it [m]
    bool is_pole;
  };
  for (const Case& c : {Case{0.04, 0.002, false}, Case{0.04, 0.03, true}, Case{0.01, 0.04, true}}) {
    Random random(8);
    const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
    const Points points = cloud(random, 60, kCentre, upright, {c.deep, c.wide, 0.19});
    const SurfelMap map = map_of(points, knots_config(), sensor);
    const Surfel* const surfel = find(map, kCentre, 0, sensor);
    EXPECT_EQ(surfel != nullptr && surfel->pole(), c.is_pole) << c.deep << ' ' << c.wide;
  }
}

TEST(SurfelMap, ABallAndAHandfulOfPointsAreNoSurfel) {
  Random random(3);
  Points ball;
  for (int i = 0; i < 150; ++i) ball.emplace_back(kCentre + 0.15 * random.unit_vector());
  EXPECT_EQ(find(map_of(ball), kCentre), nullptr);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d flat(0.18, 0.18, 0.0), tiny(0.02, 0.02, 0.0);
  EXPECT_EQ(find(map_of(cloud(random, 5, kCentre, axes, flat)), kCentre), nullptr);
  EXPECT_NE(find(map_of(cloud(random, 30, kCentre, axes, flat)), kCentre), nullptr);
  // As flat, but not broad enough to tell its normal.
  EXPECT_EQ(find(map_of(cloud(random, 30, kCentre, axes, tiny)), kCentre), nullptr);
}

TEST(SurfelMap, TheFinestLevelAskedForThatHasASurfelAnswers) {
  Random random(4);
  const SurfelMap map =
      map_of(cloud(random, 40'000, {1.6, 1.6, 0.2}, Eigen::Matrix3d::Identity(), {1.6, 1.6, 0.0}));
  for (int finest = 0; finest < 4; ++finest) {
    EXPECT_EQ(level_found(map, {1.0, 1.0, 0.2}, finest), finest);
  }
  EXPECT_EQ(level_found(map, {1.0, 1.0, 0.5}, 0), 1);  // above the finest voxel of the plane
  EXPECT_EQ(find(map, {1.0, 1.0, 3.3}), nullptr);
}

TEST(SurfelMap, BetweenRingsACoarserLevelAnswers) {
  Random random(5);
  Points rings;
  for (const double y : {0.2, 1.0, 1.8, 2.6}) {
    for (const auto& point :
         cloud(random, 60, {1.6, y, 0.1}, Eigen::Matrix3d::Identity(), {1.6, 0.0, 0.0})) {
      rings.push_back(point);
    }
  }
  const SurfelMap map = map_of(rings);
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0.5, 0.2, 0.1), {0.5, 0.6, 0.1}}) {
    const int level = level_found(map, place);
    EXPECT_EQ(level, 2) << place.transpose();  // the first whose voxels hold two rings
    const Surfel* const surfel = find(map, place);
    ASSERT_NE(surfel, nullptr);
    EXPECT_EQ(surfel->directions, 1);
    EXPECT_NEAR(std::abs(surfel->across(0).z()), 1.0, 1e-9);
  }
}

/// One ring of a LiDAR at the origin through foliage: a cone of rays, 10 deg up, ranges anywhere.
Points ring_through_foliage(Random& random, const Eigen::Vector3d& sensor) {
  const double elevation = 10.0 * kDegree;
  Points points;
  for (int i = 0; i < 60; ++i) {
    const double azimuth = random.uniform(-1.0, 1.0) * kDegree, range = random.uniform(9.7, 10.3);
    const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    points.emplace_back(sensor + range * ray);
  }
  return points;
}

TEST(SurfelMap, ThePlaneThatARingSweepsIsNoSurfel) {
  Random random(12);
  const Eigen::Vector3d sensor(0.5, 0.3, 0.4);
  const Points points = ring_through_foliage(random, sensor);
  const auto surfels = [&points](const Eigen::Vector3d& seen_from) {
    SurfelMap map(knots_config(), 100.0);
    map.insert({seen_from, points});
    return std::count_if(points.begin(), points.end(), [&map](const Eigen::Vector3d& point) {
      return find(map, point) != nullptr;
    });
  };
  EXPECT_EQ(surfels(sensor), 0);
  // The same points seen from elsewhere are a plane like any other.
  EXPECT_GT(surfels(sensor + Eigen::Vector3d(0.0, 0.0, 2.0)), 40);
}

TEST(SurfelMap, AWallHasTwoSides) {
  Random random(13);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d here(-4.0, 1.0, 0.5), there(5.0, -1.0, 0.5), half(0.0, 0.19, 0.19);
  SurfelMap map(knots_config(), 100.0);
  map.insert({here, cloud(random, 60, {0.10, 0.2, 0.2}, axes, half, 0.002)});
  const Eigen::Vector3d place(0.16, 0.2, 0.2);
  ASSERT_NE(find(map, place, 0, here), nullptr);
  EXPECT_EQ(find(map, place, 0, there), nullptr);  // nobody saw that side yet
  map.insert({there, cloud(random, 60, {0.25, 0.2, 0.2}, axes, half, 0.002)});
  const Surfel* const front = find(map, place, 0, here);
  const Surfel* const back = find(map, place, 0, there);
  ASSERT_NE(front, nullptr);
  ASSERT_NE(back, nullptr);
  EXPECT_NEAR(front->mean.x(), 0.10, 1e-3);
  EXPECT_NEAR(back->mean.x(), 0.25, 1e-3);
  EXPECT_LT(front->across(0).x(), -0.99);  // each to who sees it
  EXPECT_GT(back->across(0).x(), 0.99);
  // And both survive a cleaning.
  remove_all_far(map, {90.0, 0.0, 0.0});
  EXPECT_NEAR(find(map, place, 0, here)->mean.x(), 0.10, 1e-3);
  EXPECT_NEAR(find(map, place, 0, there)->mean.x(), 0.25, 1e-3);
}

/// Planes, poles and scatter over 12 m.
Points yard(Random& random) {
  Points points;
  const auto add = [&](const Points& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  add(cloud(random, 8000, {0.0, 0.0, 0.1}, axes, {6.0, 6.0, 0.0}, 0.01));
  add(cloud(random, 3000, {5.1, 0.0, 1.5}, axes, {0.0, 6.0, 1.5}, 0.01));
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d foot(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), 1.5);
    add(cloud(random, 150, foot, axes, {0.02, 0.02, 1.4}, 0.005));
  }
  add(cloud(random, 500, {-3.0, -3.0, 1.5}, axes, {1.0, 1.0, 1.0}));
  return points;
}

TEST(SurfelMap, ARememberedPlaceChangesNoAnswer) {
  Random random(8);
  const SurfelMap map = map_of(yard(random));
  int hits = 0, misses = 0;
  for (int walk = 0; walk < 40; ++walk) {
    Eigen::Vector3d place = random.vector(5.0);
    place.z() = random.uniform(-0.2, 1.5);
    SurfelMap::Place remembered;
    for (int step = 0; step < 200; ++step) {
      place += random.vector(step % 3 == 0 ? 0.3 : 0.02);
      const int finest = step / 40 % 4;
      const Eigen::Vector3d ray = step % 7 < 3 ? place - kSensor : random.vector(1.0);
      const Surfel* const surfel = find_again(map, place, ray, finest, remembered);
      SurfelMap::Place fresh;
      ASSERT_EQ(surfel, find_again(map, place, ray, finest, fresh));
      ASSERT_EQ(surfel, map.find(place, ray, finest));
      EXPECT_EQ(remembered.level, fresh.level);
      ++(surfel != nullptr ? hits : misses);
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 300);
}

TEST(SurfelMap, PlacesLookedUpAtOnceGetTheAnswersOfEach) {
  Random random(9);
  const SurfelMap map = map_of(yard(random));
  std::array<SurfelMap::Place, SurfelMap::kAtOnce> remembered;
  std::array<SurfelMap::Question, SurfelMap::kAtOnce> questions;
  int hits = 0;
  for (int round = 0; round < 200; ++round) {
    const int finest = round / 10 % 4;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const bool stays = round > 0 && i % 3 != 0;  // what is known already, and what is not
      const Eigen::Vector3d place = stays ? questions[i].place : random.vector(5.0);
      questions[i] = {place, i % 2 == 0 ? place - kSensor : random.vector(1.0), &remembered[i]};
    }
    map.find_all(questions, finest);
    for (const SurfelMap::Question& question : questions) {
      SurfelMap::Place fresh;
      ASSERT_EQ(question.last->surfel,
                find_again(map, question.place, question.ray, finest, fresh));
      EXPECT_EQ(question.last->level, fresh.level);
      hits += fresh.surfel != nullptr ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 800);
}

TEST(SurfelMap, TheWorldMayLieKilometresAway) {
  Random random(9);
  const Points here = yard(random);
  const Eigen::Vector3d shift(10'240.0, -10'240.0, 1024.0);  // whole voxels of every level
  Points there;
  for (const auto& point : here) there.emplace_back(point + shift);
  const SurfelMap near = map_of(here), far = map_of(there, knots_config(), kSensor + shift);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d place(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(0, 3));
    const Surfel* const a = find(near, place);
    const Surfel* const b = find(far, place + shift, 0, kSensor + shift);
    ASSERT_EQ(a == nullptr, b == nullptr);
    if (a == nullptr) continue;
    ++found;
    ASSERT_EQ(a->directions, b->directions);
    EXPECT_LT((a->mean + shift - b->mean).norm(), 1e-10);
    // A double at 10 km is good to 2 pm.
    EXPECT_NEAR(a->variance(0), b->variance(0), 1e-11);
    EXPECT_LT(a->across(0).cross(b->across(0)).norm(), 1e-6);
  }
  EXPECT_GT(found, 500);
}

TEST(SurfelMap, LevelsAreNamedByTheSizeOfTheirVoxels) {
  const SurfelMap map(knots_config(), 100.0);  // 0.4, 0.8, 1.6, 3.2 m
  EXPECT_EQ(map.level_of(0.0), 0);
  EXPECT_EQ(map.level_of(0.4), 0);
  EXPECT_EQ(map.level_of(0.41), 1);
  EXPECT_EQ(map.level_of(1.5), 2);
  EXPECT_EQ(map.level_of(3.2), 3);
  EXPECT_EQ(map.level_of(1000.0), 3);
}

}  // namespace
}  // namespace surefoot
