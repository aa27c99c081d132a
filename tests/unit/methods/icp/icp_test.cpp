// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/icp/icp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "methods/shared/constant_velocity.hpp"
#include "methods/shared/kd_tree.hpp"
#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot {
namespace {

std::vector<Eigen::Vector3d> cloud(int count, double half_side, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(random.vector(half_side));
  return points;
}

TEST(KdTree, FindsWhatLookingAtEveryPointFinds) {
  for (const int size : {1, 5, 12, 13, 200, 3000}) {
    const KdTree tree(cloud(size, 5.0, 1));
    for (const auto& query : cloud(200, 6.0, 2)) {
      std::vector<double> expected;
      for (const auto& point : tree.points()) expected.push_back((point - query).squaredNorm());
      std::sort(expected.begin(), expected.end());
      for (const double limit : {0.5, 2.0, 100.0}) {
        std::array<KdTree::Neighbour, 5> found;
        const std::size_t count = tree.nearest(query, limit, found);
        const auto within = std::lower_bound(expected.begin(), expected.end(), limit * limit);
        ASSERT_EQ(count,
                  std::min<std::size_t>(5, static_cast<std::size_t>(within - expected.begin())));
        for (std::size_t i = 0; i < count; ++i) {
          EXPECT_EQ(found[i].distance2, expected[i]);
          EXPECT_EQ((tree.points()[found[i].index] - query).squaredNorm(), expected[i]);
        }
      }
    }
  }
}

TEST(KdTree, EqualPointsAndNoPointsAreNoTrouble) {
  EXPECT_EQ(KdTree().nearest({0.0, 0.0, 0.0}, 10.0), nullptr);
  const KdTree tree(std::vector<Eigen::Vector3d>(100, {1.0, 2.0, 3.0}));
  std::array<KdTree::Neighbour, 5> found;
  EXPECT_EQ(tree.nearest({1.0, 2.0, 3.5}, 1.0, found), 5U);
  EXPECT_EQ(tree.nearest({1.0, 2.0, 4.0}, 1.0), nullptr);  // exactly at the limit: not nearer
}

TEST(Icp, TheClosedFormFindsAnyMotion) {
  test::Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Pose truth = se3_exp(random.twist(10.0, 1.5));
    PairSum pairs;
    for (const auto& point : cloud(10, 8.0, 10U + static_cast<std::uint64_t>(i))) {
      pairs.add(point, truth * point);
    }
    const Pose found = pairs.motion();
    EXPECT_LT((found.translation - truth.translation).norm(), 1e-9);
    EXPECT_LT(so3_log(found.rotation.conjugate() * truth.rotation).norm(), 1e-9);
  }
}

TEST(Icp, TheClosedFormNeverMirrors) {
  PairSum pairs;
  for (const auto& point : cloud(50, 3.0, 4)) {
    pairs.add(point, {point.x(), point.y(), -point.z()});
  }
  EXPECT_NEAR(pairs.motion().rotation.toRotationMatrix().determinant(), 1.0, 1e-9);
}

NearestTarget in(const KdTree& tree) {
  return [&tree](const Eigen::Vector3d& point, double distance) {
    return tree.nearest(point, distance);
  };
}

TEST(Icp, FindsAKnownMotionAndReportsIt) {
  const KdTree tree(cloud(2000, 5.0, 5));
  const Pose truth = se3_exp((Twist() << 0.05, -0.04, 0.02, 0.01, 0.005, -0.01).finished());
  const auto points = transformed(truth.inverse(), tree.points());
  const Alignment found =
      icp(points, in(tree), Pose{}, test::default_parameters<IcpParameters>(), Workers(1));
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.points, 2000);
  EXPECT_EQ(found.equations.count, 2000);
  EXPECT_LT((found.T_map_lidar.translation - truth.translation).norm(), 1e-6);
  EXPECT_LT(found.equations.rms(), 1e-6);
}

TEST(Icp, MatchesAreNearestNeighboursWhateverTheGuessWas) {
  // The search is bounded by the last target: it must not get stuck with it.
  const KdTree tree(cloud(3000, 4.0, 6));
  const auto points =
      transformed(se3_exp((Twist() << 0.3, 0.2, 0, 0, 0, 0.1).finished()), cloud(500, 3.0, 7));
  const Alignment found =
      icp(points, in(tree), Pose{}, test::default_parameters<IcpParameters>(), Workers(1));
  double squares = 0.0;
  for (const auto& point : transformed(found.T_map_lidar, points)) {
    squares += (*tree.nearest(point, 100.0) - point).squaredNorm();
  }
  EXPECT_NEAR(found.equations.weighted_squares, squares, 1e-9 * squares);
}

TEST(Icp, WithoutTargetsTheGuessStands) {
  const KdTree tree(cloud(10, 1.0, 8));
  const Pose guess{Eigen::Quaterniond::Identity(), {500.0, 0.0, 0.0}};
  const Alignment found = icp(cloud(100, 1.0, 9), in(tree), guess,
                              test::default_parameters<IcpParameters>(), Workers(1));
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.equations.count, 0);
  EXPECT_EQ(found.T_map_lidar.translation, guess.translation);
}

}  // namespace
}  // namespace surefoot
