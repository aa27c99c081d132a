// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/genz_icp/genz_icp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "config/method.hpp"
#include "methods/shared/adaptive_threshold.hpp"
#include "methods/shared/constant_velocity.hpp"
#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

VoxelMap map_of(const std::vector<Eigen::Vector3d>& points) {
  VoxelMap map({0.5, 4, 0.0, 100.0, CellRounding::to_zero});
  for (const auto& point : points) map.insert(point);
  return map;
}

std::vector<Eigen::Vector3d> plane(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  std::vector<Eigen::Vector3d> points;
  for (double a = -3.0; a <= 3.0; a += 0.2) {
    for (double b = -3.0; b <= 3.0; b += 0.2) {
      points.push_back(Eigen::Vector3d(5.0, 4.0, 3.0) + a * u + b * v);
    }
  }
  return points;
}

TEST(GenzIcp, PlanesArePlanarAndBlobsAreNot) {
  const Eigen::Vector3d u = Eigen::Vector3d(1.0, 0.2, 0.1).normalized();
  const Eigen::Vector3d v = u.cross(Eigen::Vector3d(0.1, 0.3, 1.0)).normalized();
  const VoxelMap flat = map_of(plane(u, v));
  const Planarity found = planarity(flat, flat.index_of({5.0, 4.0, 3.0}), 0.2);
  EXPECT_TRUE(found.planar);
  EXPECT_NEAR(std::abs(found.normal.dot(u.cross(v))), 1.0, 1e-9);

  test::Random random(1);
  std::vector<Eigen::Vector3d> blob;
  for (int i = 0; i < 400; ++i) blob.push_back(Eigen::Vector3d(5.0, 4.0, 3.0) + random.vector(0.8));
  const VoxelMap round = map_of(blob);
  EXPECT_FALSE(planarity(round, round.index_of({5.0, 4.0, 3.0}), 0.2).planar);
  EXPECT_TRUE(planarity(round, round.index_of({5.0, 4.0, 3.0}), 0.9).planar);
}

TEST(GenzIcp, FourNeighboursMakeNoPlane) {
  std::vector<Eigen::Vector3d> points = {
      {1.1, 1.1, 1.1}, {1.3, 1.1, 1.1}, {1.1, 1.3, 1.1}, {1.3, 1.3, 1.1}};
  EXPECT_FALSE(planarity(map_of(points), {2, 2, 2}, 0.2).planar);
  points.push_back({1.6, 1.2, 1.1});
  EXPECT_TRUE(planarity(map_of(points), {2, 2, 2}, 0.2).planar);
}

TEST(GenzIcp, TheThresholdLearnsOnlyAwayFromTheStart) {
  const GenzIcpParameters config = test::default_parameters<GenzIcpParameters>();
  GenzThreshold threshold(config);
  threshold.set_deviation({Eigen::Quaterniond::Identity(), {0.5, 0.0, 0.0}});
  EXPECT_EQ(threshold.threshold(false), config.initial_threshold);
  threshold.set_deviation({Eigen::Quaterniond::Identity(), {0.05, 0.0, 0.0}});
  EXPECT_EQ(threshold.threshold(true), config.initial_threshold);
  threshold.set_deviation({Eigen::Quaterniond::Identity(), {0.3, 0.0, 0.0}});
  EXPECT_NEAR(threshold.threshold(true), 0.3, 1e-12);
  threshold.set_deviation({so3_exp({0.0, 0.02, 0.0}), {0.4, 0.0, 0.0}});
  const double error = 0.4 + 200.0 * std::sin(0.01);
  EXPECT_NEAR(threshold.threshold(true), std::sqrt((0.09 + error * error) / 2.0), 1e-9);
}

TEST(GenzIcp, TheThinningIsAdaptedByTheNumberItGave) {
  test::Random random(2);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 5000; ++i) points.push_back(random.vector(8.0));
  const GenzIcpParameters config = test::default_parameters<GenzIcpParameters>();
  for (const double voxel : {0.5, 1.0, 1.5, 4.0}) {
    std::set<std::tuple<int, int, int>> cells;
    for (const auto& point : points) {
      const Eigen::Vector3i cell = (point / voxel).cast<int>();
      cells.emplace(cell.x(), cell.y(), cell.z());
    }
    const double adapted = voxel * static_cast<double>(cells.size()) / 2000.0;
    const GenzClouds clouds = adaptive_voxelize(points, voxel, config);
    EXPECT_NEAR(clouds.voxel_size, std::clamp(adapted, 0.02, 2.0), 1e-12) << voxel;
    EXPECT_GE(clouds.frame_downsample.size(), clouds.source.size());
  }
  GenzIcpParameters extreme = config;
  extreme.desired_num_voxelized_points = 1;
  EXPECT_EQ(adaptive_voxelize(points, 0.5, extreme).voxel_size, 2.0);
  extreme.desired_num_voxelized_points = 1'000'000;
  EXPECT_EQ(adaptive_voxelize(points, 0.5, extreme).voxel_size, 0.02);
}

TEST(GenzIcp, PlanarAndOtherMatchesAreWeightedByTheirNumbers) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY();
  std::vector<Eigen::Vector3d> points = plane(x, y);
  const Eigen::Vector3d pole(30.0, 0.3, 1.2);
  points.push_back(pole);
  const VoxelMap map = map_of(points);
  GenzIcpParameters config = test::default_parameters<GenzIcpParameters>();
  config.max_num_iterations = 1;
  const std::vector<Eigen::Vector3d> source = {
      {5.03, 4.02, 3.1}, {4.04, 4.43, 3.05}, pole + Eigen::Vector3d(0.1, 0.05, -0.1)};
  const double sigma = 0.9, kernel = 0.3, alpha = 2.0 / 3.0;
  const Alignment found = align_genz(source, map, Pose{}, sigma, config, Workers(1));
  EXPECT_EQ(found.equations.count, 3);
  EXPECT_FALSE(found.converged);

  Matrix6 H = Matrix6::Zero();
  Twist g = Twist::Zero();
  for (int i = 0; i < 2; ++i) {  // the plane z = 3
    const Eigen::Vector3d& s = source[static_cast<std::size_t>(i)];
    const double r = s.z() - 3.0;
    Twist J;
    J << 0.0, 0.0, 1.0, s.y(), -s.x(), 0.0;
    const double w = alpha * kernel * kernel / std::pow(kernel + r * r, 2);
    H += w * J * J.transpose();
    g += w * r * J;
  }
  Eigen::Matrix<double, 3, 6> J;
  const Eigen::Vector3d& s = source[2];
  J << 1, 0, 0, 0, s.z(), -s.y(), 0, 1, 0, -s.z(), 0, s.x(), 0, 0, 1, s.y(), -s.x(), 0;
  const Eigen::Vector3d r = s - pole;
  const double w = (1.0 - alpha) * kernel * kernel / std::pow(kernel + r.squaredNorm(), 2);
  H += w * J.transpose() * J;
  g += w * J.transpose() * r;
  EXPECT_LT((found.equations.H - H).norm(), 1e-9 * H.norm());
  EXPECT_LT((found.equations.g - g).norm(), 1e-9 * g.norm());
}

GenzIcpParameters parameters_of(const char* method) {
  return own_parameters<GenzIcpParameters>(method_config(method));
}

TEST(GenzIcp, ConfigurationsAreTheOriginalsFiles) {
  EXPECT_EQ(parameters_of("genz-icp").voxel_size, 0.3);
  EXPECT_EQ(parameters_of("genz-icp-kitti").planarity_threshold, 0.18);
  EXPECT_EQ(parameters_of("genz-icp-kitti").min_range, 5.0);
  EXPECT_EQ(parameters_of("genz-icp-exp07").max_range, 120.0);
  EXPECT_EQ(parameters_of("genz-icp-long-corridor").map_cleanup_radius, 300.0);
  EXPECT_EQ(parameters_of("genz-icp-outdoor").max_points_per_voxel, 3);
}

}  // namespace
}  // namespace surefoot
