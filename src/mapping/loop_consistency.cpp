// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_consistency.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/se3.hpp"
#include "mapping/held_pieces.hpp"

namespace surefoot::mapping {

namespace {

/// A motion and the covariance of a small motion in the frame that it ends in; what an error of the
/// odometry that is the same all along does there stands apart, since it may cancel.
struct UncertainMotion {
  Pose motion;
  Matrix6 covariance = Matrix6::Zero();
  Matrix6 common = Matrix6::Zero();  // derivative by the error of a metre

  void append(const Pose& next, const Matrix6& its_covariance) {
    const Matrix6 carry = se3_adjoint(next.inverse());
    motion = motion * next;
    common = carry * common;
    covariance = carry * covariance * carry.transpose() + its_covariance;
  }
  void append_inverse(const Pose& next, const Matrix6& its_covariance) {
    const Matrix6 back = se3_adjoint(next);  // the error sits at the end that is left
    append(next.inverse(), back * its_covariance * back.transpose());
  }
};

/// Covariance where the information may be singular: what is not held may be anything.
Matrix6 covariance_of(const Matrix6& information) {
  constexpr double kAnything = 1e-8;
  return (information + kAnything * Matrix6::Identity()).inverse();
}

/// The chain of inliers, summed up so that any stretch of it costs the same.
class Chain {
 public:
  explicit Chain(const PoseGraph& graph)
      : pose_(graph.poses.size()),
        sum_(graph.poses.size()),
        common_(graph.poses.size(), Matrix6::Zero()),
        stretch_(graph.poses.size()),
        systematic_(graph.systematic.cwiseAbs2().asDiagonal()) {
    std::vector<const PoseEdge*> step(graph.poses.size(), nullptr);
    for (const PoseEdge& edge : graph.edges) {
      // By what may be anything nothing agrees, and beside it all sums would lose their digits.
      if (edge.inlier && edge.to == edge.from + 1 && holds(edge)) step[edge.from] = &edge;
    }
    if (sum_.empty()) return;
    sum_.front().setZero();
    for (std::size_t i = 0; i + 1 < pose_.size(); ++i) {
      const bool whole = step[i] != nullptr;
      stretch_[i + 1] = stretch_[i] + (whole ? 0 : 1);
      sum_[i + 1] = sum_[i];
      common_[i + 1] = common_[i];
      if (!whole) continue;
      pose_[i + 1] = pose_[i] * step[i]->T_from_to;
      const Matrix6 carry = se3_adjoint(pose_[i + 1]);
      sum_[i + 1] += carry * covariance_of(step[i]->information) * carry.transpose();
      common_[i + 1] += step[i]->way * carry;
    }
  }

  /// False if a step between the two is missing.
  bool walk(std::size_t from, std::size_t to, UncertainMotion& motion) const {
    if (stretch_[from] != stretch_[to]) return false;
    const Matrix6 carry = se3_adjoint(pose_[to].inverse());
    const Matrix6 between =
        from < to ? Matrix6(sum_[to] - sum_[from]) : Matrix6(sum_[from] - sum_[to]);
    motion.append(pose_[from].inverse() * pose_[to], carry * between * carry.transpose());
    motion.common += carry * (common_[to] - common_[from]);  // backwards: its negative
    return true;
  }

  /// Of what is left after a walk round a cycle.
  [[nodiscard]] Matrix6 covariance(const UncertainMotion& round) const {
    return round.covariance + round.common * systematic_ * round.common.transpose();
  }

 private:
  std::vector<Pose> pose_;
  std::vector<Matrix6> sum_;     // covariance of the way from the first pose, in its axes
  std::vector<Matrix6> common_;  // derivative of it by an error of every metre, in its axes
  std::vector<int> stretch_;     // poses with the same number are joined
  Matrix6 systematic_;
};

bool agree(const Chain& chain, const PoseEdge& a, const Matrix6& covariance_a, const PoseEdge& b,
           const Matrix6& covariance_b) {
  UncertainMotion round;
  round.append(a.T_from_to, covariance_a);
  if (!chain.walk(a.to, b.to, round)) return false;
  round.append_inverse(b.T_from_to, covariance_b);
  if (!chain.walk(b.from, a.from, round)) return false;
  const Twist error = se3_log(round.motion);
  return error.dot(chain.covariance(round).ldlt().solve(error)) < kChi2Of6At99;
}

std::size_t apart(std::size_t a, std::size_t b) { return a < b ? b - a : a - b; }

/// Branch and bound over sets of vertices, coloured greedily (after Tomita and Seki).
class CliqueSearch {
 public:
  explicit CliqueSearch(const std::vector<std::vector<bool>>& agree) : agree_(agree) {}

  std::vector<std::size_t> find() {
    std::vector<std::size_t> all(agree_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<std::ptrdiff_t> degrees;
    for (const std::size_t vertex : all) degrees.push_back(degree(vertex));
    std::stable_sort(all.begin(), all.end(),
                     [&](std::size_t a, std::size_t b) { return degrees[a] > degrees[b]; });
    // Mostly they all agree: then there is nothing to search for.
    for (const std::size_t vertex : all) {
      const bool joins = std::all_of(best_.begin(), best_.end(),
                                     [&](std::size_t other) { return agree_[vertex][other]; });
      if (joins) best_.push_back(vertex);
    }
    expand(all);
    std::sort(best_.begin(), best_.end());
    return best_;
  }

 private:
  [[nodiscard]] std::ptrdiff_t degree(std::size_t vertex) const {
    return std::count(agree_[vertex].begin(), agree_[vertex].end(), true);
  }

  void expand(const std::vector<std::size_t>& candidates) {
    constexpr std::size_t kMostSteps = 2'000'000;
    const auto [order, colors] = color(candidates);
    for (std::size_t i = order.size(); i-- > 0;) {
      if (current_.size() + colors[i] <= best_.size() || ++steps_ > kMostSteps) return;
      current_.push_back(order[i]);
      std::vector<std::size_t> rest;
      for (std::size_t k = 0; k < i; ++k) {
        if (agree_[order[i]][order[k]]) rest.push_back(order[k]);
      }
      if (rest.empty()) {
        if (current_.size() > best_.size()) best_ = current_;
      } else {
        expand(rest);
      }
      current_.pop_back();
    }
  }

  /// Vertices by colour, and how many colours there are up to each: no clique is larger.
  [[nodiscard]] std::pair<std::vector<std::size_t>, std::vector<std::size_t>> color(
      const std::vector<std::size_t>& candidates) const {
    std::vector<std::vector<std::size_t>> classes;
    for (const std::size_t vertex : candidates) {
      const auto free = std::find_if(classes.begin(), classes.end(), [&](const auto& members) {
        return std::none_of(members.begin(), members.end(),
                            [&](std::size_t other) { return agree_[vertex][other]; });
      });
      if (free == classes.end()) {
        classes.push_back({vertex});
      } else {
        free->push_back(vertex);
      }
    }
    std::vector<std::size_t> order, colors;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      order.insert(order.end(), classes[c].begin(), classes[c].end());
      colors.insert(colors.end(), classes[c].size(), c + 1);
    }
    return {order, colors};
  }

  const std::vector<std::vector<bool>>& agree_;
  std::vector<std::size_t> current_, best_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<bool> supported_loops(const PoseGraph& graph, std::size_t reach) {
  const Chain chain(graph);
  std::vector<std::size_t> loops;
  std::vector<Matrix6> covariances(graph.edges.size());
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e].inlier) continue;
    loops.push_back(e);
    covariances[e] = covariance_of(graph.edges[e].information);
  }
  std::sort(loops.begin(), loops.end(), [&](std::size_t a, std::size_t b) {
    return graph.edges[a].from < graph.edges[b].from;
  });
  std::vector<bool> supported(graph.edges.size(), false);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const PoseEdge& a = graph.edges[loops[i]];
    for (std::size_t k = i + 1; k < loops.size(); ++k) {
      const PoseEdge& b = graph.edges[loops[k]];
      if (b.from - a.from > reach) break;
      if (apart(a.to, b.to) > reach || (supported[loops[i]] && supported[loops[k]])) continue;
      if (!agree(chain, a, covariances[loops[i]], b, covariances[loops[k]])) continue;
      supported[loops[i]] = supported[loops[k]] = true;
    }
  }
  return supported;
}

std::vector<std::vector<bool>> pairwise_agreement(const PoseGraph& graph,
                                                  const std::vector<std::size_t>& loops) {
  const Chain chain(graph);
  std::vector<Matrix6> covariances;
  for (const std::size_t e : loops) {
    covariances.push_back(covariance_of(graph.edges[e].information));
  }
  std::vector<std::vector<bool>> result(loops.size(), std::vector<bool>(loops.size(), false));
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t k = i + 1; k < loops.size(); ++k) {
      result[i][k] = result[k][i] = agree(chain, graph.edges[loops[i]], covariances[i],
                                          graph.edges[loops[k]], covariances[k]);
    }
  }
  return result;
}

std::vector<bool> agreement_of(const PoseGraph& graph,
                               const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  const Chain chain(graph);
  std::vector<bool> result;
  for (const auto& [one, other] : pairs) {
    const PoseEdge& a = graph.edges[one];
    const PoseEdge& b = graph.edges[other];
    result.push_back(
        agree(chain, a, covariance_of(a.information), b, covariance_of(b.information)));
  }
  return result;
}

std::vector<std::size_t> largest_clique(const std::vector<std::vector<bool>>& agree) {
  return CliqueSearch(agree).find();
}

RobustSolution close_loops(PoseGraph& graph, std::size_t reach) {
  const std::vector<bool> supported = supported_loops(graph, reach);
  std::vector<std::size_t> kept;
  PoseGraph reduced;
  reduced.poses = graph.poses;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!graph.edges[e].inlier && !supported[e]) continue;
    kept.push_back(e);
    reduced.edges.push_back(graph.edges[e]);
  }
  const RobustSolution solved = solve_robustly(reduced);
  graph.poses = reduced.poses;
  RobustSolution result;
  result.rounds = solved.rounds;
  result.weights.assign(graph.edges.size(), 0.0);
  for (std::size_t i = 0; i < kept.size(); ++i) result.weights[kept[i]] = solved.weights[i];
  return result;
}

}  // namespace surefoot::mapping
