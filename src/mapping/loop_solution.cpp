// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_solution.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

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

namespace {

constexpr std::size_t kMostVoters = 600;  // pairs of them are asked, a third of a million at most
constexpr std::size_t kAsked = 10;        // of those that agree, by whom the others are judged

/// Of loops that are many, the best of each stretch of the way.
std::vector<std::size_t> voters_of(const std::vector<Loop>& loops,
                                   const std::vector<std::size_t>& numbers) {
  if (numbers.size() <= kMostVoters) return numbers;
  std::vector<std::size_t> voters;
  for (std::size_t k = 0; k < kMostVoters; ++k) {
    const auto from =
        numbers.begin() + static_cast<std::ptrdiff_t>(k * numbers.size() / kMostVoters);
    const auto to =
        numbers.begin() + static_cast<std::ptrdiff_t>((k + 1) * numbers.size() / kMostVoters);
    voters.push_back(*std::max_element(from, to, [&](std::size_t a, std::size_t b) {
      return loops[a].check.overlap < loops[b].check.overlap;
    }));
  }
  return voters;
}

/// The largest set of the voters that all agree, and the others that agree with those of it that
/// lie nearest by their numbers. `edge_number`: of a loop in the graph.
std::vector<std::size_t> agreeing(const PoseGraph& graph, const std::vector<Loop>& loops,
                                  const std::vector<std::size_t>& numbers,
                                  const std::vector<std::size_t>& edges) {
  const std::vector<std::size_t> voters = voters_of(loops, numbers);
  const auto edge_of_number = [&](std::size_t number) {
    return edges[static_cast<std::size_t>(std::lower_bound(numbers.begin(), numbers.end(), number) -
                                          numbers.begin())];
  };
  std::vector<std::size_t> voting;
  for (const std::size_t voter : voters) voting.push_back(edge_of_number(voter));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : largest_clique(pairwise_agreement(graph, voting))) {
    chosen.push_back(voters[i]);
  }
  if (voters.size() == numbers.size() || chosen.size() < 2) return chosen;
  const std::vector<std::size_t> clique = chosen;
  std::vector<std::pair<std::size_t, std::size_t>> asked;  // edges
  std::vector<std::size_t> askers;                         // of each pair, the loop
  for (const std::size_t number : numbers) {
    if (std::binary_search(voters.begin(), voters.end(), number)) continue;
    const auto next = static_cast<std::size_t>(
        std::lower_bound(clique.begin(), clique.end(), number) - clique.begin());
    const std::size_t first = next > kAsked / 2 ? next - kAsked / 2 : 0;
    for (std::size_t k = first; k < std::min(first + kAsked, clique.size()); ++k) {
      asked.emplace_back(edge_of_number(number), edge_of_number(clique[k]));
      askers.push_back(number);
    }
  }
  const std::vector<bool> answers = agreement_of(graph, asked);
  for (std::size_t i = 0; i < asked.size();) {
    const std::size_t number = askers[i];
    bool agrees = true;
    for (; i < asked.size() && askers[i] == number; ++i) agrees = agrees && answers[i];
    if (agrees) chosen.push_back(number);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
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
  std::vector<std::size_t> chosen = agreeing(with_loops, loops, numbers, edges);
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
