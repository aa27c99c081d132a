// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A graph solved with loops that may still be false.
#pragma once

#include <functional>
#include <vector>

#include "mapping/loop_finder.hpp"
#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Of the loops that are taken so far, the largest set that all agree with each other over the
/// graph's steps, two at least, by their numbers, ascending. The others are alone or outvoted. Only
/// those that are `asked`; none given: all.
std::vector<std::size_t> keep_consistent(const PoseGraph& graph, std::vector<Loop>& loops,
                                         const std::function<bool(const Loop&)>& asked = {});

/// Adds the loops to the graph and moves its poses; undoes loops that are switched off, and those
/// that bend an edge known to be right beyond its bounds, until none does and two at least are
/// left. Of each loop: taken, outvoted, strains, or alone if it would be the only one. Where none
/// is left, the graph is as it was. A loop's `from` lies before its `to`.
std::vector<LoopVerdict> solve_with_loops(PoseGraph& graph, const std::vector<PoseEdge>& loops);

/// The same with some of the loops, by their numbers; their verdicts say what came of them.
void take_loops(PoseGraph& graph, std::vector<Loop>& loops, const std::vector<std::size_t>& chosen);

}  // namespace surefoot::mapping
