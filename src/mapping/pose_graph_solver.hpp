// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The poses that a graph's edges agree on best.
#pragma once

#include <vector>

#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Whether this program can solve graphs (it was built with Ceres).
[[nodiscard]] bool has_solver();

/// Moves the poses to the nearest minimum of the edges' chi-squared, each times its weight (empty:
/// 1). Returns that sum. Throws std::runtime_error if there is no solver.
double solve(PoseGraph& graph, const std::vector<double>& weights = {}, int max_iterations = 100);

struct RobustSolution {
  std::vector<double> weights;  ///< of the edges: 1 taken, 0 switched off
  int rounds = 0;
};
/// The same where edges that are not known to be right may be false: graduated non-convexity with
/// truncated least squares (Yang, Antonante, Tzoumas, Carlone, 2020). An edge whose chi-squared
/// stays above `bound` ends with the weight 0 and bends nothing.
RobustSolution solve_robustly(PoseGraph& graph, double bound = kChi2Of6At99);

}  // namespace surefoot::mapping
