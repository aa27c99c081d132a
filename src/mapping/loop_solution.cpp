// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "mapping/loop_consistency.hpp"
#include "mapping/pose_graph_solver.hpp"

namespace surefoot::mapping {

namespace {

/// What is wrong with a solution, by the loops' places behind the `known` edges.
struct Undone {
  std::vector<std::size_t> loops;
  bool whole = true;  ///< no known edge is bent beyond its bounds
};

/// The loops that were switched off, or else the one that pulls a strained edge hardest.
Undone loops_to_undo(const PoseGraph& graph, std::size_t known, const RobustSolution& solution) {
  const auto end = graph.edges.begin() + static_cast<std::ptrdiff_t>(known);
  const auto strained = std::find_if(graph.edges.begin(), end, [&](const PoseEdge& edge) {
    return chi2(edge, graph.poses) > kChi2Of6At999;
  });
  Undone undone;
  undone.whole = strained == end;
  double worst = -1.0;
  std::size_t pulling = 0;
  for (std::size_t k = 0; known + k < graph.edges.size(); ++k) {
    const PoseEdge& loop = graph.edges[known + k];
    if (solution.weights[known + k] == 0.0) undone.loops.push_back(k);
    if (undone.whole || loop.from > strained->from || loop.to < strained->to) continue;
    if (const double pull = chi2(loop, graph.poses); pull > worst) {
      worst = pull;
      pulling = k;
    }
  }
  // Where nothing that could be undone spans the edge, `loops` stays empty.
  if (undone.loops.empty() && worst >= 0.0) undone.loops.push_back(pulling);
  return undone;
}

}  // namespace

std::vector<std::size_t> keep_consistent(const PoseGraph& graph, std::vector<Loop>& loops,
                                         const std::function<bool(const Loop&)>& asked) {
  PoseGraph with_loops = graph;
  std::vector<std::size_t> numbers, edges;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].check.verdict != LoopVerdict::taken || (asked && !asked(loops[i]))) continue;
    numbers.push_back(i);
    edges.push_back(with_loops.edges.size());
    with_loops.edges.push_back(edge_of(loops[i]));
  }
  const std::vector<std::size_t> clique = largest_clique(pairwise_agreement(with_loops, edges));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : clique) chosen.push_back(numbers[i]);
  const LoopVerdict refusal = chosen.size() < 2 ? LoopVerdict::alone : LoopVerdict::outvoted;
  if (chosen.size() < 2) chosen.clear();
  for (const std::size_t i : numbers) {
    if (!std::binary_search(chosen.begin(), chosen.end(), i)) loops[i].check.verdict = refusal;
  }
  return chosen;
}

std::vector<LoopVerdict> solve_with_loops(PoseGraph& graph, const std::vector<PoseEdge>& loops) {
  std::vector<LoopVerdict> verdicts(loops.size(), LoopVerdict::taken);
  std::vector<std::size_t> chosen(loops.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  const PoseGraph before = graph;
  while (!chosen.empty()) {
    graph = before;
    for (const std::size_t i : chosen) graph.edges.push_back(loops[i]);
    const RobustSolution solution = solve_robustly(graph);
    const Undone undone = loops_to_undo(graph, before.edges.size(), solution);
    if (undone.loops.empty() && undone.whole) return verdicts;
    if (undone.loops.empty()) break;
    for (const std::size_t k : undone.loops) {
      verdicts[chosen[k]] = undone.whole ? LoopVerdict::outvoted : LoopVerdict::strains;
    }
    std::vector<std::size_t> kept;
    for (const std::size_t i : chosen) {
      if (verdicts[i] == LoopVerdict::taken) kept.push_back(i);
    }
    chosen = kept.size() < 2 ? std::vector<std::size_t>{} : kept;
    if (kept.size() == 1) verdicts[kept.front()] = LoopVerdict::alone;
  }
  for (const std::size_t i : chosen) verdicts[i] = LoopVerdict::strains;
  graph = before;
  return verdicts;
}

void take_loops(PoseGraph& graph, std::vector<Loop>& loops,
                const std::vector<std::size_t>& chosen) {
  std::vector<PoseEdge> edges;
  for (const std::size_t i : chosen) edges.push_back(edge_of(loops[i]));
  const std::vector<LoopVerdict> verdicts = solve_with_loops(graph, edges);
  for (std::size_t k = 0; k < chosen.size(); ++k) loops[chosen[k]].check.verdict = verdicts[k];
}

}  // namespace surefoot::mapping
