// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "config/method.hpp"
#include "methods/ct_icp/ct_icp_attempts.hpp"
#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

CtIcpParameters defaults() { return test::default_parameters<CtIcpParameters>(); }

TEST(CtIcp, WeightsAreTheOriginals) {
  // (0.9 * 0.5^2 + 0.1 * exp(-3 / (0.3 * 20))) / 1.0
  EXPECT_NEAR(ct_icp_weight(0.5, 3.0, defaults()), 0.225 + 0.1 * std::exp(-0.5), 1e-12);
  CtIcpParameters config = defaults();
  config.weight_alpha = 8.0;
  config.weight_neighborhood = 2.0;
  EXPECT_NEAR(ct_icp_weight(1.0, 0.0, config), 1.0, 1e-12);
}

std::vector<VoxelNeighbours::Neighbour> neighbours_of(const std::vector<Eigen::Vector3d>& points) {
  std::vector<VoxelNeighbours::Neighbour> neighbours;
  for (const auto& point : points) neighbours.push_back({0.0, &point});
  return neighbours;
}

TEST(CtIcp, PlanarityIsTheRatioOfSpreads) {
  // Spread sqrt(2/6) * (3, 2, 1) along three axes that stand anyhow, far from the origin.
  test::Random random(1);
  const Pose T{so3_exp(random.vector(1.0)), {1000.0, -500.0, 30.0}};
  std::vector<Eigen::Vector3d> points;
  for (const double sign : {-1.0, 1.0}) {
    for (int k = 0; k < 3; ++k) points.push_back(T * (sign * (3.0 - k) * Eigen::Vector3d::Unit(k)));
  }
  const CtIcpPlane plane = fit_ct_icp_plane(neighbours_of(points));
  EXPECT_NEAR(plane.planarity, (2.0 - 1.0) / 3.0, 1e-9);
  EXPECT_NEAR(std::abs(plane.normal.dot(T.rotation * Eigen::Vector3d::UnitZ())), 1.0, 1e-9);
}

constexpr double kHalf = 6.0;  // [m] of a room about the origin

/// The six walls, a point every 0.12 m.
VoxelMap room() {
  VoxelMap map({0.5, 40, 0.02, 100.0, CellRounding::to_zero});
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-kHalf, kHalf}) {
      for (double a = -kHalf; a <= kHalf; a += 0.12) {
        for (double b = -kHalf; b <= kHalf; b += 0.12) {
          Eigen::Vector3d point;
          point[axis] = side;
          point[(axis + 1) % 3] = a;
          point[(axis + 2) % 3] = b;
          map.insert(point);
        }
      }
    }
  }
  return map;
}

/// Points of the walls, away from the edges, as a sensor sees them that moves by `truth`.
std::vector<CtIcpPoint> seen(const CtIcpFrame& truth, int count) {
  test::Random random(3);
  const CtIcpMotion motion(truth);
  std::vector<CtIcpPoint> points;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d on_wall = random.vector(kHalf - 1.2);
    on_wall[i % 3] = i % 2 == 0 ? -kHalf : kHalf;
    const double alpha = random.uniform(0.0, 1.0);
    points.push_back({motion.at(alpha).inverse() * on_wall, alpha});
  }
  return points;
}

const CtIcpFrame kTruth{{so3_exp({0.01, -0.02, 0.03}), {0.1, -0.05, 0.02}},
                        {so3_exp({-0.01, 0.01, 0.08}), {0.3, -0.02, 0.06}}};

double farthest_corner(const CtIcpFrame& a, const CtIcpFrame& b) {
  return (a.begin.translation - b.begin.translation).norm() +
         (a.end.translation - b.end.translation).norm() +
         a.begin.rotation.angularDistance(b.begin.rotation) +
         a.end.rotation.angularDistance(b.end.rotation);
}

TEST(CtIcp, FindsTheMotionWithinAScan) {
  const VoxelMap map = room();
  const VoxelNeighbours neighbours(map, 0.8, 20);
  const Workers workers(1);
  for (const bool nearest : {false, true}) {
    CtIcpParameters config = defaults();
    config.nearest_anchor = nearest;
    config.beta_location_consistency = config.beta_constant_velocity = 0.0;
    config.num_iters_icp = 50;
    const CtIcpResult result =
        register_ct_icp(seen(kTruth, 900), neighbours, {}, {}, config, workers);
    EXPECT_TRUE(result.success);
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.residuals, 900);
    EXPECT_LT(farthest_corner(result.frame, kTruth), 1e-3);
  }
}

TEST(CtIcp, ThreadsDoNotChangeABit) {
  const VoxelMap map = room();
  const VoxelNeighbours neighbours(map, 0.8, 20);
  const Workers one(1), three(3);
  const auto points = seen(kTruth, 900);
  const CtIcpResult a = register_ct_icp(points, neighbours, {}, {}, defaults(), one);
  const CtIcpResult b = register_ct_icp(points, neighbours, {}, {}, defaults(), three);
  EXPECT_EQ(a.frame.begin.translation, b.frame.begin.translation);
  EXPECT_EQ(a.frame.end.rotation.coeffs(), b.frame.end.rotation.coeffs());
  EXPECT_EQ(a.equations.H, b.equations.H);
}

TEST(CtIcp, StopsAtItsNumbers) {
  const VoxelMap map = room();
  const VoxelNeighbours neighbours(map, 0.8, 20);
  const Workers workers(1);
  CtIcpParameters config = defaults();
  config.max_num_residuals = 100;
  config.num_iters_icp = 1;
  const CtIcpResult few = register_ct_icp(seen(kTruth, 900), neighbours, {}, {}, config, workers);
  EXPECT_EQ(few.residuals, 100);
  EXPECT_EQ(few.iterations, 1);
  EXPECT_FALSE(few.converged);
  EXPECT_FALSE(register_ct_icp(seen(kTruth, 19), neighbours, {}, {}, config, workers).success);
  EXPECT_TRUE(register_ct_icp(seen(kTruth, 20), neighbours, {}, {}, config, workers).success);
}

TEST(CtIcp, TheAnchorIsTheFarthestNeighbourUnlessSetRight) {
  const VoxelMap map = room();
  const VoxelNeighbours neighbours(map, 0.8, 20);
  const Eigen::Vector3d placed(1.23, 2.34, kHalf - 0.05);
  std::vector<VoxelNeighbours::Neighbour> found;
  neighbours.find(placed, found);
  CtIcpParameters config = defaults();
  EXPECT_EQ(match_ct_icp({placed, 0.0}, placed, neighbours, config)->anchor, *found.back().point);
  config.nearest_anchor = true;
  EXPECT_EQ(match_ct_icp({placed, 0.0}, placed, neighbours, config)->anchor, *found.front().point);
  EXPECT_FALSE(match_ct_icp({placed, 0.0}, {0.0, 0.0, 0.0}, neighbours, config).has_value());
}

TEST(CtIcpAttempts, EveryLevelTriesHarder) {
  const CtIcpParameters config =
      own_parameters<CtIcpParameters>(method_config("ct-icp-low-inertia"));
  CtIcpEffort effort = first_effort(config, false, 0);
  EXPECT_EQ(effort.sample_voxel_size, 1.5);
  EXPECT_EQ(effort.config.num_iters_icp, 30);
  effort.increase();
  EXPECT_EQ(effort.config.ls_max_num_iters, 40);
  EXPECT_EQ(effort.config.num_iters_icp, 50);
  EXPECT_EQ(effort.config.max_num_residuals, 1200);
  EXPECT_NEAR(effort.config.threshold_orientation_norm, 1e-3, 1e-15);
  EXPECT_NEAR(effort.config.threshold_translation_norm, 1e-4, 1e-15);
  EXPECT_NEAR(effort.config.ls_sigma, 0.24, 1e-15);
  EXPECT_NEAR(effort.config.max_dist_to_plane_ct_icp, 0.75, 1e-15);
  EXPECT_NEAR(effort.sample_voxel_size, 1.0, 1e-15);
  EXPECT_EQ(first_effort(config, false, 2).level, 2);
  const CtIcpEffort start = first_effort(defaults(), true, 0);
  EXPECT_EQ(start.config.num_iters_icp, 15);
  EXPECT_EQ(start.sample_voxel_size, 1.0);
}

TEST(CtIcpAttempts, FastTurnsArePlausibleOnlyForPlainProfilesAndHigherLevels) {
  const CtIcpResult good{.frame = {}, .success = true, .equations = {}};
  const CtIcpChange slow{0.1, 1.0, 1.0}, fast{0.1, 4.0, 1.0}, far{6.0, 1.0, 1.0};
  const CtIcpParameters robust =
      own_parameters<CtIcpParameters>(method_config("ct-icp-low-inertia"));
  EXPECT_TRUE(is_plausible(good, slow, 0, robust));
  EXPECT_FALSE(is_plausible(good, fast, 0, robust));
  EXPECT_TRUE(is_plausible(good, fast, 1, robust));
  EXPECT_TRUE(is_plausible(good, fast, 0, defaults()));
  EXPECT_FALSE(is_plausible(good, far, 1, defaults()));
  EXPECT_FALSE(is_plausible({}, slow, 1, defaults()));
  EXPECT_TRUE(is_plausible(good, {2.0, 0.0, 0.0}, 0, defaults()));
  EXPECT_FALSE(is_plausible(good, {2.0, 0.0, 0.0}, 1, robust));
}

TEST(CtIcpAttempts, FastTurnsStayOutOfTheMap) {
  const CtIcpResult good{.frame = {}, .success = true, .equations = {}};
  const CtIcpChange slow{0.1, 1.0, 1.0}, fast{0.1, 4.0, 1.0};
  CtIcpParameters config = own_parameters<CtIcpParameters>(method_config("ct-icp-low-inertia"));
  CtIcpCaution original(config);
  for (int scan = 0; scan < 20; ++scan) EXPECT_FALSE(original.admit(good, fast, 3));
  EXPECT_EQ(original.level(), 1);
  EXPECT_TRUE(original.admit(good, slow, 1));
  EXPECT_EQ(original.level(), 0);
  EXPECT_TRUE(original.admit({}, slow, 3));
  EXPECT_EQ(original.level(), 2);

  config.robust_bookkeeping = true;
  CtIcpCaution counting(config);
  for (int scan = 0; scan < 5; ++scan) EXPECT_FALSE(counting.admit(good, fast, 3));
  EXPECT_TRUE(counting.admit(good, fast, 3));  // the sixth in succession
}

}  // namespace
}  // namespace surefoot
