// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/mapper.hpp"

#include <algorithm>

#include "mapping/loop_consistency.hpp"
#include "mapping/pose_graph_solver.hpp"

namespace surefoot::mapping {

namespace {

PoseEdge edge_of(const Loop& loop) {
  PoseEdge edge;
  edge.from = loop.place;
  edge.to = loop.query;
  edge.T_from_to = loop.check.alignment.T_target_source;
  edge.information = loop.check.alignment.information;
  edge.inlier = false;
  return edge;
}

}  // namespace

void Mapper::add(const PlacedScan& scan, const DeskewedScan& points) {
  if (auto piece = builder_.add(scan, points)) finder_.add(std::move(*piece));
}

void Mapper::finish() {
  if (auto piece = builder_.finish()) finder_.add(std::move(*piece));
  finder_.finish();
  loops_ = finder_.loops();
  graph_.poses.clear();
  for (const Piece& piece : pieces()) graph_.poses.push_back(piece.T_world_piece);
  graph_.edges = finder_.odometry();
  graph_.systematic = systematic_drift(options_.loops.drift);
  if (options_.close_loops) choose_loops();
}

std::size_t Mapper::taken() const {
  return static_cast<std::size_t>(std::count_if(loops_.begin(), loops_.end(), [](const Loop& loop) {
    return loop.check.verdict == LoopVerdict::taken;
  }));
}

/// The largest set of loops that all agree with each other, by their numbers. The others' verdicts
/// say so.
std::vector<std::size_t> Mapper::consistent_loops() {
  PoseGraph graph = graph_;
  std::vector<std::size_t> numbers, edges;
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    if (loops_[i].check.verdict != LoopVerdict::taken) continue;
    numbers.push_back(i);
    edges.push_back(graph.edges.size());
    graph.edges.push_back(edge_of(loops_[i]));
  }
  const std::vector<std::size_t> clique = largest_clique(pairwise_agreement(graph, edges));
  std::vector<std::size_t> chosen;
  for (const std::size_t i : clique) chosen.push_back(numbers[i]);
  const LoopVerdict refusal = chosen.size() < 2 ? LoopVerdict::alone : LoopVerdict::outvoted;
  if (chosen.size() < 2) chosen.clear();
  for (const std::size_t i : numbers) {
    if (!std::binary_search(chosen.begin(), chosen.end(), i)) loops_[i].check.verdict = refusal;
  }
  return chosen;
}

void Mapper::choose_loops() {
  std::vector<std::size_t> chosen = consistent_loops();
  if (!chosen.empty()) solve_without_strain(chosen);
}

/// Solves, and undoes loops as long as the odometry is bent beyond its bounds somewhere.
void Mapper::solve_without_strain(std::vector<std::size_t>& chosen) {
  const PoseGraph odometry = graph_;
  while (!chosen.empty()) {
    graph_ = odometry;
    for (const std::size_t i : chosen) graph_.edges.push_back(edge_of(loops_[i]));
    const RobustSolution solution = solve_robustly(graph_);
    const std::size_t first_loop = odometry.edges.size();
    const auto strained = std::find_if(
        graph_.edges.begin(), graph_.edges.begin() + static_cast<std::ptrdiff_t>(first_loop),
        [&](const PoseEdge& edge) { return chi2(edge, graph_.poses) > kChi2Of6At999; });
    const bool whole = strained == graph_.edges.begin() + static_cast<std::ptrdiff_t>(first_loop);
    // The loops that were switched off, or else the one that pulls the strained edge hardest.
    std::vector<std::size_t> undone;
    double worst = -1.0;
    std::size_t pulling = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const PoseEdge& loop = graph_.edges[first_loop + k];
      if (solution.weights[first_loop + k] == 0.0) undone.push_back(k);
      if (whole || loop.from > strained->from || loop.to < strained->to) continue;
      if (const double pull = chi2(loop, graph_.poses); pull > worst) {
        worst = pull;
        pulling = k;
      }
    }
    if (undone.empty() && whole) return;
    if (undone.empty() && worst < 0.0) break;  // nothing that could be undone spans it
    if (undone.empty()) undone.push_back(pulling);
    for (const std::size_t k : undone) {
      loops_[chosen[k]].check.verdict = whole ? LoopVerdict::outvoted : LoopVerdict::strains;
    }
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (std::find(undone.begin(), undone.end(), k) == undone.end()) kept.push_back(chosen[k]);
    }
    chosen = kept.size() < 2 ? std::vector<std::size_t>{} : kept;
    if (kept.size() == 1) loops_[kept.front()].check.verdict = LoopVerdict::alone;
  }
  for (const std::size_t i : chosen) loops_[i].check.verdict = LoopVerdict::strains;
  graph_ = odometry;
}

Pose Mapper::correction(std::int64_t stamp_ns) const {
  const std::vector<Piece>& all = pieces();
  if (all.empty() || graph_.poses.size() != all.size()) return {};
  const auto at = [&](std::size_t i) { return graph_.poses[i] * all[i].T_world_piece.inverse(); };
  const auto after =
      static_cast<std::size_t>(std::upper_bound(all.begin(), all.end(), stamp_ns,
                                                [](std::int64_t stamp, const Piece& piece) {
                                                  return stamp < piece.stamp_ns;
                                                }) -
                               all.begin());
  if (after == 0) return at(0);
  if (after == all.size() || all[after].restarted) return at(after - 1);
  // The motion between the two corrected pieces, spread evenly over the odometry's: interpolated at
  // where the robot was, so that it does not matter how far away the world's origin is.
  const double share =
      static_cast<double>(stamp_ns - all[after - 1].stamp_ns) /
      static_cast<double>(std::max<std::int64_t>(all[after].stamp_ns - all[after - 1].stamp_ns, 1));
  const Pose& before_pose = all[after - 1].T_world_piece;
  const Pose correction_before = at(after - 1);
  const Pose correction_after = at(after);
  const Pose between =
      (correction_before * before_pose).inverse() * (correction_after * before_pose);
  const Pose here = correction_before * before_pose * se3_exp(share * se3_log(between));
  return here * before_pose.inverse();
}

}  // namespace surefoot::mapping
