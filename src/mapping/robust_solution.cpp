// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "mapping/pose_graph_solver.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kSharpen = 1.4;  // the surrogate's step towards truncation
constexpr int kMostRounds = 100;
constexpr int kIterationsPerRound = 10;  // the next round goes on from there

/// The weight that truncated least squares' surrogate gives a residual.
double surrogate_weight(double chi2, double bound, double mu) {
  if (chi2 >= (mu + 1.0) / mu * bound) return 0.0;
  if (chi2 <= mu / (mu + 1.0) * bound) return 1.0;
  return std::sqrt(bound * mu * (mu + 1.0) / chi2) - mu;
}

}  // namespace

RobustSolution solve_robustly(PoseGraph& graph, double bound) {
  RobustSolution result;
  result.weights.assign(graph.edges.size(), 1.0);
  const auto largest = [&] {
    double value = 0.0;
    for (const PoseEdge& edge : graph.edges) {
      if (!edge.inlier) value = std::max(value, chi2(edge, graph.poses));
    }
    return value;
  };
  // Where the edges that are known to be right leave the poses, the others are judged first.
  std::vector<double> known(graph.edges.size());
  for (std::size_t e = 0; e < known.size(); ++e) known[e] = graph.edges[e].inlier ? 1.0 : 0.0;
  solve(graph, known);
  const double worst = largest();
  if (worst <= bound) {
    solve(graph);
    if (largest() <= bound) return result;
  }
  // Where all of them can be met at once none is false, and the rounds below would say the same.
  PoseGraph met = graph;
  solve(met);
  std::swap(met.poses, graph.poses);
  if (largest() <= bound) return result;
  std::swap(met.poses, graph.poses);
  double mu = bound / std::max(2.0 * worst - bound, bound);
  for (; result.rounds < kMostRounds; ++result.rounds, mu *= kSharpen) {
    bool decided = true;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      if (graph.edges[e].inlier) continue;
      double& weight = result.weights[e];
      weight = surrogate_weight(chi2(graph.edges[e], graph.poses), bound, mu);
      decided &= weight == 0.0 || weight == 1.0;
    }
    solve(graph, result.weights, kIterationsPerRound);
    if (decided && result.rounds > 0) break;
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!graph.edges[e].inlier) result.weights[e] = result.weights[e] < 0.5 ? 0.0 : 1.0;
  }
  solve(graph, result.weights);
  return result;
}

}  // namespace surefoot::mapping
