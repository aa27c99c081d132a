// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/pose_graph.hpp"

#include <gtest/gtest.h>

#include "geometry/se3.hpp"
#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

using test::Random;

TEST(Se3Calculus, AdjointCarriesATwistThroughAMotion) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose pose = {so3_exp(random.vector(2.0)), random.vector(5.0)};
    const Twist twist = (Twist() << random.vector(1.0), random.vector(1.0)).finished();
    const Pose left = pose * se3_exp(twist);
    const Pose right = se3_exp(se3_adjoint(pose) * twist) * pose;
    EXPECT_LT((left.matrix() - right.matrix()).norm(), 1e-12);
  }
}

TEST(Se3Calculus, RightJacobianAgreesWithDifferences) {
  Random random(2);
  for (const double angle : {0.0, 1e-6, 0.049, 0.051, 0.5, 2.0, 3.0}) {
    Twist twist;
    twist << random.vector(3.0), angle * random.unit_vector();
    const Matrix6 inverse = se3_right_jacobian_inverse(twist);
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 6; ++k) {
      const Twist step = kStep * Twist::Unit(k);
      const Twist difference =
          (se3_log(se3_exp(twist) * se3_exp(step)) - se3_log(se3_exp(twist) * se3_exp(-step))) /
          (2.0 * kStep);
      EXPECT_LT((inverse.col(k) - difference).norm(), 2e-8) << "angle " << angle;
    }
  }
}

TEST(PoseGraph, DerivativesOfAnEdgeAgreeWithDifferences) {
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    PoseEdge edge;
    edge.T_from_to = {so3_exp(random.vector(1.0)), random.vector(3.0)};
    const Pose from = {so3_exp(random.vector(1.0)), random.vector(3.0)};
    const Pose to = from * edge.T_from_to * se3_exp(0.3 * Twist::Ones());
    const EdgeJacobians by = edge_jacobians(edge_error(edge, from, to), from, to);
    constexpr double kStep = 1e-6;
    for (int k = 0; k < 6; ++k) {
      const Pose ahead = se3_exp(kStep * Twist::Unit(k));
      const Pose back = ahead.inverse();
      const Twist by_from =
          (edge_error(edge, from * ahead, to) - edge_error(edge, from * back, to)) / (2 * kStep);
      const Twist by_to =
          (edge_error(edge, from, to * ahead) - edge_error(edge, from, to * back)) / (2 * kStep);
      EXPECT_LT((by.from.col(k) - by_from).norm(), 1e-7);
      EXPECT_LT((by.to.col(k) - by_to).norm(), 1e-7);
    }
  }
}

TEST(PoseGraph, ARightEdgeCostsNothing) {
  PoseGraph graph;
  graph.poses = {{}, {so3_exp({0.1, 0.2, 0.3}), {1.0, 2.0, 3.0}}};
  PoseEdge edge;
  edge.to = 1;
  edge.T_from_to = graph.poses[1];
  graph.edges = {edge};
  EXPECT_NEAR(chi2(graph), 0.0, 1e-24);
  graph.poses[1].translation += graph.poses[1].rotation * Eigen::Vector3d(0.0, 0.0, 0.5);
  EXPECT_NEAR(chi2(graph), 0.25, 1e-12);
}

}  // namespace
}  // namespace surefoot::mapping
