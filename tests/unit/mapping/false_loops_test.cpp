// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// False loops added to public pose graphs: none is left.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "mapping/loop_consistency.hpp"
#include "unit/mapping/benchmark_graphs.hpp"
#include "unit/mapping/graph_guess.hpp"

namespace surefoot::mapping {
namespace {

/// Where the right loops alone have the poses.
PoseGraph optimum_of(PoseGraph graph) {
  for (PoseEdge& edge : graph.edges) edge.inlier = true;
  test::guess_by_rotations(graph);
  solve(graph);
  return graph;
}

/// Makes the edges' covariances those that their errors have: the garage's file states a hundred
/// times as much, by which hardly anything could be called false. The optimum stays where it is.
void calibrate(PoseGraph& graph, const PoseGraph& optimum) {
  const auto freedom = 6.0 * (static_cast<double>(graph.edges.size() - graph.poses.size()) + 1.0);
  const double scale = freedom / chi2(optimum);
  for (PoseEdge& edge : graph.edges) edge.information *= scale;
}

/// So many false loops for every right one, drawn by a fixed seed: between any two poses, with
/// another loop's motion. What the edge's own covariance cannot tell from a right one is not false.
std::size_t add_false_loops(PoseGraph& graph, const std::vector<Pose>& optimum, double share) {
  constexpr double kFalse = 10.0 * kChi2Of6At999;
  std::vector<PoseEdge> loops;
  for (const PoseEdge& edge : graph.edges) {
    if (!edge.inlier) loops.push_back(edge);
  }
  const std::size_t first = graph.edges.size();
  const auto count = static_cast<std::size_t>(share * static_cast<double>(loops.size()));
  std::mt19937 random(7);
  while (graph.edges.size() < first + count) {
    PoseEdge edge = loops[random() % loops.size()];
    edge.from = random() % (graph.poses.size() - 1);
    edge.to = edge.from + 1 + random() % (graph.poses.size() - edge.from - 1);
    edge.T_from_to = loops[random() % loops.size()].T_from_to;
    if (chi2(edge, optimum) > kFalse) graph.edges.push_back(edge);
  }
  return first;
}

void expect_none_survives(const std::string& name, double share, double kept) {
  auto graph = test::benchmark_graph(name);
  if (!graph) GTEST_SKIP() << "no ../shared/data/pose_graphs";
  const PoseGraph optimum = optimum_of(*graph);
  calibrate(*graph, optimum);
  const std::size_t first = add_false_loops(*graph, optimum.poses, share);
  test::follow_edges(*graph);
  const RobustSolution solution = close_loops(*graph);
  std::size_t right = 0, taken = 0, survivors = 0;
  for (std::size_t e = 0; e < graph->edges.size(); ++e) {
    if (graph->edges[e].inlier) continue;
    const bool on = solution.weights[e] > 0.0;
    if (e >= first) survivors += on ? 1 : 0;
    if (e < first) ++right;
    if (e < first) taken += on ? 1 : 0;
  }
  EXPECT_EQ(survivors, 0U) << name << " with " << share;
  EXPECT_GT(static_cast<double>(taken), kept * static_cast<double>(right)) << name;
}

TEST(FalseLoops, OfFalseLoopsInTheParkingGarageNoneSurvives) {
  for (const double share : {0.1, 0.3, 0.5}) {
    expect_none_survives("parking-garage.g2o", share, 0.85);
  }
}

TEST(FalseLoops, OfFalseLoopsOnTheSphereNoneSurvives) {
  for (const double share : {0.1, 0.3, 0.5}) expect_none_survives("sphere2500.txt", share, 0.95);
}

}  // namespace
}  // namespace surefoot::mapping
