// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/drift_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace surefoot::mapping {
namespace {

/// Two pieces, `way` [m] apart, the second one turned left about a corner.
std::vector<Piece> round_a_corner(double way) {
  std::vector<Piece> pieces(2);
  pieces[1].T_world_piece = {so3_exp({0.0, 0.0, 0.5 * std::numbers::pi}), {way, 0.0, 0.0}};
  pieces[1].way = way;
  for (Piece& piece : pieces) piece.covariance = 1e-6 * Matrix6::Identity();
  return pieces;
}

Matrix6 covariance_of(const std::vector<Piece>& pieces, const DriftModel& model) {
  return odometry_edge(pieces, 0, model).information.inverse();
}

// What a corridor left open along its way lies across the way round its corner.
TEST(DriftModel, AnEdgesErrorIsInTheAxesOfItsLaterPiece) {
  std::vector<Piece> pieces = round_a_corner(1.0);
  pieces[0].covariance(0, 0) = 0.01;
  const Matrix6 covariance = covariance_of(pieces, {});
  EXPECT_NEAR(covariance(1, 1) - covariance(0, 0), 0.5 * (0.01 - 1e-6), 1e-9);
}

TEST(DriftModel, WhatIsWrongAllAlongGrowsWithTheWay) {
  DriftModel without;
  without.systematic_translation = without.systematic_rotation_deg = 0.0;
  const std::vector<Piece> pieces = round_a_corner(5.0);
  const Matrix6 more = covariance_of(pieces, {}) - covariance_of(pieces, without);
  EXPECT_NEAR(more(0, 0), std::pow(5.0 * 0.001, 2), 1e-12);
  EXPECT_NEAR(more(5, 5), std::pow(5.0 * 0.005 * std::numbers::pi / 180.0, 2), 1e-12);
}

TEST(DriftModel, WhereTheOdometryBeganAnewAnEdgeSaysNothing) {
  std::vector<Piece> pieces = round_a_corner(5.0);
  EXPECT_EQ(odometry_edge(pieces, 0, {}).way, 5.0);
  pieces[1].restarted = true;
  const PoseEdge edge = odometry_edge(pieces, 0, {});
  EXPECT_LT(edge.information.cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(edge.way, 0.0);
}

// Two edges of 5 m: what is wrong of one is moved aside by the turn that is wrong of the other, and
// what is wrong of both adds up.
TEST(DriftModel, WhatIsWrongAllAlongAddsUpOverEdges) {
  std::vector<Piece> pieces(3);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].way = pieces[i].T_world_piece.translation.x() = 5.0 * static_cast<double>(i);
  }
  const auto drift = [&](const DriftModel& model) {
    return drift_between(pieces, {odometry_edge(pieces, 0, model), odometry_edge(pieces, 1, model)},
                         0, 2, model);
  };
  DriftModel without;
  without.systematic_translation = without.systematic_rotation_deg = 0.0;
  const Matrix6 more = drift({}) - drift(without);
  const double along = std::pow(10.0 * 0.001, 2) + 2.0 * std::pow(5.0 * 0.001, 2);
  const double turned = std::pow(5.0 * 5.0 * 0.005 * std::numbers::pi / 180.0, 2);
  EXPECT_NEAR(more(0, 0), along, 1e-9);
  EXPECT_NEAR(more(1, 1), along + 2.0 * turned, 1e-9);
}

}  // namespace
}  // namespace surefoot::mapping
