// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/pose_graph.hpp"

#include "geometry/se3.hpp"

namespace surefoot::mapping {

Twist edge_error(const PoseEdge& edge, const Pose& from, const Pose& to) {
  return se3_log(edge.T_from_to.inverse() * (from.inverse() * to));
}

EdgeJacobians edge_jacobians(const Twist& error, const Pose& from, const Pose& to) {
  const Matrix6 by_to = se3_right_jacobian_inverse(error);
  return {-by_to * se3_adjoint(to.inverse() * from), by_to};
}

double chi2(const PoseEdge& edge, const std::vector<Pose>& poses) {
  const Twist error = edge_error(edge, poses[edge.from], poses[edge.to]);
  return error.dot(edge.information * error);
}

double chi2(const PoseGraph& graph) {
  double sum = 0.0;
  for (const PoseEdge& edge : graph.edges) sum += chi2(edge, graph.poses);
  return sum;
}

}  // namespace surefoot::mapping
