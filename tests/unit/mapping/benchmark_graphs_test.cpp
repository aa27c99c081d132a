// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Public pose graphs, solved to the optimum that others found or that statistics demand.
#include <gtest/gtest.h>

#include <cmath>

#include "mapping/pose_graph_solver.hpp"
#include "unit/mapping/benchmark_graphs.hpp"
#include "unit/mapping/graph_guess.hpp"

namespace surefoot::mapping {
namespace {

PoseGraph all_inliers(PoseGraph graph) {
  for (PoseEdge& edge : graph.edges) edge.inlier = true;
  return graph;
}

/// Ceres' own example ends at half of this (6.341883e-01, borglab/gtsam issue 248).
TEST(BenchmarkGraphs, ParkingGarageReachesItsKnownOptimum) {
  const auto graph = test::benchmark_graph("parking-garage.g2o");
  if (!graph) GTEST_SKIP() << "no ../shared/data/pose_graphs";
  ASSERT_EQ(graph->poses.size(), 1661U);
  ASSERT_EQ(graph->edges.size(), 6275U);
  PoseGraph from_file = *graph;
  EXPECT_NEAR(solve(from_file), 2.0 * 0.6341883, 2e-5);
  PoseGraph from_rotations = all_inliers(*graph);
  test::guess_by_rotations(from_rotations);
  EXPECT_NEAR(solve(from_rotations), 2.0 * 0.6341883, 2e-5);
}

/// Made with the noise that the file states: the optimum is chi-squared distributed, and no start
/// finds a better one.
TEST(BenchmarkGraphs, Sphere2500ReachesTheOptimumThatItsNoiseDemands) {
  const auto graph = test::benchmark_graph("sphere2500.txt");
  auto truth = test::benchmark_graph("sphere2500_groundtruth.txt");
  if (!graph || !truth) GTEST_SKIP() << "no ../shared/data/pose_graphs";
  ASSERT_EQ(graph->poses.size(), 2500U);
  ASSERT_EQ(graph->edges.size(), 4949U);
  const double freedom = 6.0 * 4949 - 6.0 * 2499;

  PoseGraph from_rotations = all_inliers(*graph);
  test::guess_by_rotations(from_rotations);
  const double optimum = solve(from_rotations);
  EXPECT_NEAR(optimum, freedom, 3.0 * std::sqrt(2.0 * freedom));

  PoseGraph from_odometry = *graph;
  test::follow_edges(from_odometry);
  EXPECT_NEAR(solve(from_odometry), optimum, 1e-3);

  PoseGraph from_truth = *graph;
  test::follow_edges(*truth);
  from_truth.poses = truth->poses;
  EXPECT_NEAR(solve(from_truth), optimum, 1e-3);
}

}  // namespace
}  // namespace surefoot::mapping
