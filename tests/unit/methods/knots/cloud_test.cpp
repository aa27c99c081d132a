// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Clouds: what a voxel of leaves, grass or stones tells, that holds neither plane nor pole.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "methods/knots/surfel_map.hpp"
#include "support/random.hpp"
#include "unit/methods/knots/surfel_clouds.hpp"

namespace surefoot {
namespace {

using test::Random;
using Points = std::vector<Eigen::Vector3d>;

const Eigen::Vector3d kCloudSensor(-6.0, 3.0, 1.0);
const Eigen::Vector3d kMiddle(0.2, 0.2, 0.2);  // of the finest voxel at the origin

Config::Knots cloud_config() {
  Config::Knots config = Config().knots;
  config.finest_voxel = 0.4;
  config.levels = 4;
  config.divided_at = 0;
  config.ring_gap = 0.03;
  return config;
}

SurfelMap cloud_map_of(const Points& points, const Config::Knots& config = cloud_config()) {
  SurfelMap map(config, 100.0);
  map.insert({kCloudSensor, points});
  return map;
}

const Surfel* cloud_surfel(const SurfelMap& map, const Eigen::Vector3d& place, int finest = 0) {
  return map.find(place, place - kCloudSensor, finest);
}

Points shrub(Random& random, int count, double radius) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(kMiddle + radius * random.unit_vector());
  return points;
}

/// Of a surfel with three directions [m^2].
Eigen::Matrix3d covariance_of(const Surfel& surfel) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int d = 0; d < 3; ++d) {
    sum += surfel.variance(d) * surfel.across(d) * surfel.across(d).transpose();
  }
  return sum;
}

struct Gaussian {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};
Gaussian gaussian_of(const Points& points) {
  Gaussian result;
  const auto count = static_cast<double>(points.size());
  for (const auto& p : points) result.mean += p / count;
  for (const auto& p : points) {
    result.covariance += (p - result.mean) * (p - result.mean).transpose() / count;
  }
  return result;
}

/// By [K24]: what lies up to the next ring, on either side, is unseen in so far as the rays leave
/// out what they have room for.
Eigen::Matrix3d unseen_between(const Points& points, double gap, double size) {
  Points rays;
  double squared_range = 0.0;
  for (const auto& p : points) {
    rays.push_back((p - kCloudSensor).normalized());
    squared_range += (p - kCloudSensor).squaredNorm() / static_cast<double>(points.size());
  }
  const Gaussian spread = gaussian_of(rays);
  const Eigen::Vector3d ray = spread.mean.normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - ray * ray.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(across * spread.covariance * across);
  const double room = std::min(gap, size / std::sqrt(squared_range));
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 1; i < 3; ++i) {  // the first is along the ray
    const Eigen::Vector3d axis = axes.eigenvectors().col(i);
    const double left_out = 1.0 - 12.0 * axes.eigenvalues()[i] / (room * room);
    sum += std::max(left_out, 0.0) * gap * gap * squared_range / 3.0 * axis * axis.transpose();
  }
  return sum;
}

TEST(Cloud, ItIsItsPointsGaussianAndWhatTheRingsLeaveUnseen) {
  Random random(21);
  for (const double radius : {0.03, 0.08, 0.15}) {
    const Points points = shrub(random, 100, radius);
    const SurfelMap map = cloud_map_of(points);
    const Surfel* const cloud = cloud_surfel(map, kMiddle);
    ASSERT_NE(cloud, nullptr);
    ASSERT_TRUE(cloud->cloud());
    const Gaussian points_own = gaussian_of(points);
    const Eigen::Matrix3d between = unseen_between(points, 0.03, 0.4);
    EXPECT_LT((cloud->mean - points_own.mean).norm(), 1e-8);  // single precision
    // How far the rays spread is told by differences of sums in single precision.
    EXPECT_LT((covariance_of(*cloud) - points_own.covariance - between).norm(), 5e-5);
    EXPECT_EQ(between.norm() == 0.0, radius > 0.1) << "rays all over leave nothing out";
  }
}

TEST(Cloud, OneRingTellsNothingBetweenTheRingsAndAllAlongThem) {
  Random random(22);
  Points ring;  // along y, as one beam sweeps it over a leaf: no height at all
  for (int i = 0; i < 40; ++i) ring.emplace_back(0.2, random.uniform(0.02, 0.38), 0.2);
  const SurfelMap map = cloud_map_of(ring);
  const Surfel* const cloud = cloud_surfel(map, kMiddle);
  ASSERT_NE(cloud, nullptr);
  ASSERT_TRUE(cloud->cloud());
  const double range = (kMiddle - kCloudSensor).norm();
  EXPECT_GT(covariance_of(*cloud)(2, 2), 0.9 * 0.03 * 0.03 * range * range / 3.0);
  // The farther, the less is known.
  EXPECT_LT(covariance_of(*cloud)(2, 2), 1.1 * 0.03 * 0.03 * range * range / 3.0);
  // Its own extent; the gap between two rings would be 0.014 m^2.
  EXPECT_LT(covariance_of(*cloud)(1, 1), 1.1 * gaussian_of(ring).covariance(1, 1));
}

/// The worth of the direction that lies along this one.
double worth_along(const Surfel& cloud, const Eigen::Vector3d& direction) {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    const auto cosine = [&](int j) { return std::abs(cloud.across(j).dot(direction)); };
    if (cosine(i) > cosine(nearest)) nearest = i;
  }
  return cloud.worth(nearest);
}

TEST(Cloud, OneRingIsWorthNothingAlongItsRaysAndWhatFillsAVoxelNothingInIt) {
  const Eigen::Vector3d ahead(-6.0, 0.2, 0.2);
  Points ring;  // sweeps the voxel from end to end, at one range
  for (int i = 0; i < 40; ++i) ring.emplace_back(0.2, 0.005 + 0.01 * i, 0.2);
  SurfelMap map(cloud_config(), 100.0);
  map.insert({ahead, ring});
  const Surfel* const cloud = map.find(kMiddle, kMiddle - ahead, 0);
  ASSERT_NE(cloud, nullptr);
  ASSERT_TRUE(cloud->cloud());
  EXPECT_LT(worth_along(*cloud, Eigen::Vector3d::UnitX()), 0.01) << "along the rays";
  EXPECT_LT(worth_along(*cloud, Eigen::Vector3d::UnitY()), 0.05) << "along the ring";
}

TEST(Cloud, WhatManyRingsMeetIsWorthAllThatItDoesNotFillOfItsVoxel) {
  Random random(25);
  const Points points = shrub(random, 200, 0.08);
  Config::Knots dense = cloud_config();
  dense.ring_gap = 0.003;  // of a LiDAR of 128 rings
  const SurfelMap few = cloud_map_of(points), many = cloud_map_of(points, dense);
  const Surfel* const cloud = cloud_surfel(many, kMiddle);
  ASSERT_NE(cloud, nullptr);
  ASSERT_TRUE(cloud->cloud());
  for (int i = 0; i < 3; ++i) {
    const double known = cloud->variance(i) + dense.noise * dense.noise;
    EXPECT_NEAR(cloud->worth(i), 1.0 - known * 12.0 / (0.4 * 0.4), 1e-6);
    EXPECT_GT(cloud->worth(i), 0.7);
  }
  const Eigen::Vector3d ray = (kMiddle - kCloudSensor).normalized();
  EXPECT_LT(worth_along(*cloud_surfel(few, kMiddle), ray), 0.3) << "16 rings: one or two";
}

TEST(Cloud, PlanesAndPolesComeFirstOnWhicheverGrid) {
  Points rings;  // of a floor, 0.8 m apart: lines in the finest voxels, a plane in coarser ones
  for (int row = 0; row < 4; ++row) {
    for (int i = 0; i < 60; ++i) rings.emplace_back(0.053 * i, 0.2 + 0.8 * row, 0.1);
  }
  const SurfelMap map = cloud_map_of(rings);
  for (const Eigen::Vector3d& place : {Eigen::Vector3d(0.5, 0.2, 0.1), {0.5, 0.6, 0.1}}) {
    const Surfel* const surfel = cloud_surfel(map, place);
    ASSERT_NE(surfel, nullptr);
    EXPECT_EQ(surfel->directions, 1);
  }
  Config::Knots fine = cloud_config();
  fine.levels = 1;
  const SurfelMap lines = cloud_map_of(rings, fine);
  const Surfel* const line = cloud_surfel(lines, {0.5, 0.2, 0.1});
  ASSERT_NE(line, nullptr);
  EXPECT_TRUE(line->cloud());
}

TEST(Cloud, TheFinestOneAnswersAgainAndAgain) {
  Random random(23);
  const SurfelMap map = cloud_map_of(shrub(random, 200, 0.6));
  for (int finest = 0; finest < 4; ++finest) {
    SurfelMap::Place remembered;
    const Eigen::Vector3d place = kMiddle + Eigen::Vector3d(0.45, 0.3, 0.2);
    const Surfel* const first =
        test::find_again(map, place, place - kCloudSensor, finest, remembered);
    if (first == nullptr) continue;
    EXPECT_EQ(test::find_again(map, place, place - kCloudSensor, finest, remembered), first);
    EXPECT_EQ(cloud_surfel(map, place, finest), first);
    if (first->cloud()) {
      EXPECT_GE(remembered.level, finest);
    }
  }
  ASSERT_NE(cloud_surfel(map, kMiddle, 2), nullptr);
  EXPECT_TRUE(cloud_surfel(map, kMiddle, 2)->cloud());
}

TEST(Cloud, NoneOfTooFewPointsAndNoneWithoutWeight) {
  Random random(24);
  const Points points = shrub(random, 100, 0.15);
  EXPECT_EQ(cloud_surfel(cloud_map_of(Points(points.begin(), points.begin() + 5)), kMiddle),
            nullptr);
  Config::Knots without = cloud_config();
  without.cloud_weight = 0.0;
  EXPECT_EQ(cloud_surfel(cloud_map_of(points, without), kMiddle), nullptr);
}

}  // namespace
}  // namespace surefoot
