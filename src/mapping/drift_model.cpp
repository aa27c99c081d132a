// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/drift_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numbers>
#include <optional>

#include "geometry/se3.hpp"

namespace surefoot::mapping {

namespace {

/// The motion between two pieces of one frame, as uncertain as such a way of walking makes it.
PoseEdge edge_between(const std::vector<Piece>& pieces, std::size_t from, std::size_t to,
                      double way, const DriftModel& model) {
  const Piece& a = pieces[from];
  const Piece& b = pieces[to];
  PoseEdge edge;
  edge.from = from;
  edge.to = to;
  edge.T_from_to = a.T_world_piece.inverse() * b.T_world_piece;
  const double rotation = model.rotation_deg * std::numbers::pi / 180.0;
  const double t2 = model.translation * model.translation * way + model.standing * model.standing;
  const double r2 = rotation * rotation * std::max(way, 0.2);
  Twist diagonal;
  diagonal << t2, t2, t2, r2, r2, r2;
  diagonal += (way * systematic_drift(model)).cwiseAbs2();
  const Matrix6 covariance = 0.5 * (turned(a.covariance, edge.T_from_to.rotation) + b.covariance) +
                             Matrix6(diagonal.asDiagonal());
  edge.information = covariance.inverse();
  return edge;
}

}  // namespace

Twist systematic_drift(const DriftModel& model) {
  Twist result;
  result.head<3>().setConstant(model.systematic_translation);
  result.tail<3>().setConstant(model.systematic_rotation_deg * std::numbers::pi / 180.0);
  return result;
}

PoseEdge odometry_edge(const std::vector<Piece>& pieces, std::size_t from,
                       const DriftModel& model) {
  const double way = std::max(pieces[from + 1].way - pieces[from].way, 0.0);
  PoseEdge edge = edge_between(pieces, from, from + 1, way, model);
  if (pieces[from + 1].restarted) {
    edge.information = 1e-9 * Matrix6::Identity();
    return edge;
  }
  edge.way = way;
  return edge;
}

std::vector<PoseEdge> homecomings(const std::vector<Piece>& pieces, const DriftModel& model) {
  const auto apart = [&](std::size_t i, std::size_t k) {
    return (pieces[i].T_world_piece.translation - pieces[k].T_world_piece.translation).norm();
  };
  std::vector<PoseEdge> result;
  for (std::size_t here = 1; here < pieces.size(); ++here) {
    if (!pieces[here].restarted) continue;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < here; ++i) {
      if (pieces[i].frame != pieces[here].frame) continue;
      if (!nearest || apart(i, here) < apart(*nearest, here)) nearest = i;
    }
    if (!nearest) continue;
    result.push_back(edge_between(pieces, *nearest, here, apart(*nearest, here), model));
    result.back().inlier = false;
  }
  return result;
}

std::vector<Matrix6> drifts_to(const std::vector<Piece>& pieces,
                               const std::vector<PoseEdge>& odometry, std::size_t to,
                               const DriftModel& model) {
  std::vector<Matrix6> result(to + 1, Matrix6::Zero());
  const Pose T_to_world = pieces[to].T_world_piece.inverse();
  const Matrix6 systematic = systematic_drift(model).cwiseAbs2().asDiagonal();
  Matrix6 walked = Matrix6::Zero();  // the covariance of what is drawn anew at every step
  Matrix6 common = Matrix6::Zero();  // what a metre's error does at the end, over the way
  for (std::size_t i = to; i-- > 0;) {
    // The edge's error is a motion in its later piece's frame.
    const Matrix6 carry = se3_adjoint(T_to_world * pieces[i + 1].T_world_piece);
    walked += carry * odometry[i].information.inverse() * carry.transpose();
    common += odometry[i].way * carry;
    result[i] = walked + common * systematic * common.transpose();
  }
  return result;
}

Matrix6 drift_between(const std::vector<Piece>& pieces, const std::vector<PoseEdge>& odometry,
                      std::size_t from, std::size_t to, const DriftModel& model) {
  return drifts_to(pieces, odometry, to, model)[from];
}

}  // namespace surefoot::mapping
