// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "unit/mapping/graph_guess.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "geometry/decompositions.hpp"

namespace surefoot::test {

using mapping::PoseEdge;
using mapping::PoseGraph;

namespace {

/// One pass over the edges, as long as they reach new poses.
void spread(PoseGraph& graph, std::vector<bool>& known, bool inliers) {
  for (bool more = true; more;) {
    more = false;
    for (const PoseEdge& edge : graph.edges) {
      if (edge.inlier != inliers || known[edge.from] == known[edge.to]) continue;
      if (known[edge.from]) {
        graph.poses[edge.to] = graph.poses[edge.from] * edge.T_from_to;
      } else {
        graph.poses[edge.from] = graph.poses[edge.to] * edge.T_from_to.inverse();
      }
      known[edge.from] = known[edge.to] = true;
      more = true;
    }
  }
}

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// x = argmin |A x - b|^2 for every column of b.
Eigen::MatrixXd least_squares(const Triplets& entries, const Eigen::MatrixXd& b,
                              Eigen::Index unknowns) {
  Sparse A(b.rows(), unknowns);
  A.setFromTriplets(entries.begin(), entries.end());
  const Sparse normal = A.transpose() * A;
  const Eigen::SimplicialLDLT<Sparse> factor(normal);
  return factor.solve(A.transpose() * b);
}

std::vector<const PoseEdge*> inliers_of(const PoseGraph& graph) {
  std::vector<const PoseEdge*> result;
  for (const PoseEdge& edge : graph.edges) {
    if (edge.inlier) result.push_back(&edge);
  }
  return result;
}

/// Weight of an edge's rotation and of its translation: the mean of its information.
double rotation_weight(const PoseEdge& edge) {
  return std::sqrt(std::max(edge.information.bottomRightCorner<3, 3>().trace() / 3.0, 1e-12));
}
double translation_weight(const PoseEdge& edge) {
  return std::sqrt(std::max(edge.information.topLeftCorner<3, 3>().trace() / 3.0, 1e-12));
}

}  // namespace

void follow_edges(PoseGraph& graph) {
  if (graph.poses.empty()) return;
  std::vector<bool> known(graph.poses.size(), false);
  known[0] = true;
  spread(graph, known, true);
  spread(graph, known, false);
}

void guess_by_rotations(PoseGraph& graph) {
  const std::vector<const PoseEdge*> edges = inliers_of(graph);
  const auto poses = static_cast<Eigen::Index>(graph.poses.size());
  if (edges.empty() || poses < 2) return;
  follow_edges(graph);  // what no inlier reaches
  // The rows of R_to = R_from * R_from_to, one pose's nine numbers as a 3 x 3 block of x.
  const auto rows = static_cast<Eigen::Index>(3 * edges.size());
  Triplets entries;
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(rows + 3 * poses, 3);
  Eigen::Index row = 0;
  for (const PoseEdge* edge : edges) {
    const double w = rotation_weight(*edge);
    const Eigen::Matrix3d Rt = edge->T_from_to.rotation.toRotationMatrix().transpose();
    for (Eigen::Index k = 0; k < 3; ++k) {
      entries.emplace_back(row + k, 3 * edge->to + k, w);
      for (Eigen::Index m = 0; m < 3; ++m) {
        entries.emplace_back(row + k, 3 * edge->from + m, -w * Rt(k, m));
      }
    }
    row += 3;
  }
  constexpr double kHold = 1e-6;  // where nothing else does
  for (Eigen::Index i = 0; i < poses; ++i) {
    const double hold = i == 0 ? 1e4 : kHold;
    for (Eigen::Index k = 0; k < 3; ++k) entries.emplace_back(row + k, 3 * i + k, hold);
    b.block<3, 3>(row, 0) = hold * graph.poses[i].rotation.toRotationMatrix().transpose();
    row += 3;
  }
  const Eigen::MatrixXd transposed = least_squares(entries, b, 3 * poses);
  for (Eigen::Index i = 1; i < poses; ++i) {
    graph.poses[i].rotation = nearest_rotation(transposed.block<3, 3>(3 * i, 0).transpose());
  }

  entries.clear();
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(edges.size()) + poses, 3);
  row = 0;
  for (const PoseEdge* edge : edges) {
    const double w = translation_weight(*edge);
    entries.emplace_back(row, edge->to, w);
    entries.emplace_back(row, edge->from, -w);
    c.row(row++) = w * (graph.poses[edge->from].rotation * edge->T_from_to.translation).transpose();
  }
  for (Eigen::Index i = 0; i < poses; ++i) {
    const double hold = i == 0 ? 1e4 : kHold;
    entries.emplace_back(row, i, hold);
    c.row(row++) = hold * graph.poses[i].translation.transpose();
  }
  const Eigen::MatrixXd places = least_squares(entries, c, poses);
  for (Eigen::Index i = 1; i < poses; ++i) graph.poses[i].translation = places.row(i).transpose();
}

}  // namespace surefoot::test
