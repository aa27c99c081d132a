// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Loops that agree with each other. A false one is rarely alone in being wrong by itself, but it is
// alone in being wrong this way.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mapping/pose_graph.hpp"
#include "mapping/pose_graph_solver.hpp"

namespace surefoot::mapping {

/// For every edge that is no inlier, whether another one agrees with it: round the cycle of the two
/// and the inliers between their ends the motions cancel, within chi-squared 0.99. Asked of loops
/// whose ends lie at most `reach` inliers apart, so that the cycle is short enough to say
/// something. Inliers lead from each pose to the next; what hold nothing, where the odometry began
/// anew, are none.
[[nodiscard]] std::vector<bool> supported_loops(const PoseGraph& graph, std::size_t reach);

/// Which of the edges `loops` agree with each other, asked of all pairs.
[[nodiscard]] std::vector<std::vector<bool>> pairwise_agreement(
    const PoseGraph& graph, const std::vector<std::size_t>& loops);

/// The same of the pairs asked, by their numbers among the graph's edges.
[[nodiscard]] std::vector<bool> agreement_of(
    const PoseGraph& graph, const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

/// The largest set of vertices that all agree with each other, ascending. `agree` is symmetric.
/// Exact up to some millions of steps, else the best set found by then.
[[nodiscard]] std::vector<std::size_t> largest_clique(const std::vector<std::vector<bool>>& agree);

/// Switches off loops that no other agrees with, then those that bend the rest (solve_robustly),
/// and moves the poses. Weights of all edges.
RobustSolution close_loops(PoseGraph& graph, std::size_t reach = 12);

}  // namespace surefoot::mapping
