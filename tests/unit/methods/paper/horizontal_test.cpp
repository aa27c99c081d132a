// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The horizontal stage, eqs. (13), (15), (16), (18), (19), and the coupled problem (4), against
// sums over dense matrices written out as in the paper.
#include "methods/paper/horizontal.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "methods/paper/coupled.hpp"
#include "methods/paper/robust_weight.hpp"
#include "registration_fixture.hpp"

namespace surefoot {
namespace {

using test::Random;

struct HorizontalScene {
  PaperParameters config = test::step_config();
  Pose T{so3_exp({0.02, -0.03, 0.4}), {1.0, -0.5, 0.2}};
  LocalMap map = test::make_map(test::room_points(1, 1000), config);
  Source source;

  HorizontalScene() {
    const Pose T_true = apply_update(T, (Twist() << 0.1, 0.05, -0.1, 0.01, -0.02, 0.03).finished());
    source = test::make_source(test::room_points(2, 150), T_true);
    test::match_by_brute_force(source, map.points(), T, 0.8);
  }
};

/// Eq. (19) as printed.
double paper_weight(double residual, double kappa) {
  return kappa * kappa / ((kappa + residual) * (kappa + residual));
}

/// J^p and r of every match, as printed, s about the sensor.
struct DenseRow {
  Eigen::Matrix<double, 3, 6> J;
  Eigen::Vector3d r;
};
std::vector<DenseRow> dense_rows(const HorizontalScene& scene) {
  std::vector<DenseRow> rows;
  for (std::size_t i = 0; i < scene.source.points.size(); ++i) {
    if (!scene.source.matches[i].found) continue;
    const Eigen::Vector3d place = scene.T * scene.source.points[i].cast<double>();
    DenseRow row;
    row.J << Eigen::Matrix3d::Identity(), -test::skew(place - scene.T.translation);
    row.r = place - scene.source.matches[i].target;
    rows.push_back(row);
  }
  return rows;
}

TEST(Horizontal, NormalEquationsEqualTheDenseSum) {
  const HorizontalScene scene;
  Eigen::Matrix<double, 6, 3> S_H;
  S_H << 1, 0, 0, /**/ 0, 1, 0, /**/ 0, 0, 0, /**/ 0, 0, 0, /**/ 0, 0, 0, /**/ 0, 0, 1;
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  double weights = 0.0, squares = 0.0;
  const auto rows = dense_rows(scene);
  for (const DenseRow& row : rows) {
    const Eigen::Matrix3d J = row.J * S_H;
    const double w = paper_weight(row.r.norm(), scene.config.horizontal.kernel_scale);
    H += w * J.transpose() * J;
    g += w * J.transpose() * row.r;
    weights += w;
    squares += w * row.r.squaredNorm();
  }
  const auto sum = horizontal_equations(scene.source, scene.T, scene.config.horizontal, Workers(1));
  ASSERT_GT(rows.size(), 500U);
  EXPECT_EQ(sum.count, static_cast<int>(rows.size()));
  EXPECT_LT((sum.H - H).norm(), 1e-10 * H.norm());
  EXPECT_LT((sum.g - g).norm(), 1e-10 * g.norm());
  EXPECT_NEAR(sum.rms(), std::sqrt(squares / weights), 1e-12);
  EXPECT_LT((sum.solve() + H.inverse() * g).norm(), 1e-10);
}

TEST(Horizontal, ThreadsDoNotChangeABit) {
  const HorizontalScene scene;
  const auto alone =
      horizontal_equations(scene.source, scene.T, scene.config.horizontal, Workers(1));
  for (const int threads : {2, 3, 8}) {
    const auto together =
        horizontal_equations(scene.source, scene.T, scene.config.horizontal, Workers(threads));
    EXPECT_EQ(together.H, alone.H);
    EXPECT_EQ(together.g, alone.g);
  }
}

TEST(Horizontal, RobustWeightIsTheSquaredLorentzian) {
  for (const double kappa : {1e-4, 0.1, 0.3, 5.0}) {
    EXPECT_DOUBLE_EQ(lorentzian_weight(0.0, kappa), 1.0);
    EXPECT_DOUBLE_EQ(lorentzian_weight(kappa, kappa), 0.25);
    double last = 1.0;
    for (const double r : {0.01, 0.1, 0.5, 2.0, 100.0}) {
      EXPECT_NEAR(lorentzian_weight(r, kappa), paper_weight(r, kappa), 1e-15);
      EXPECT_LT(lorentzian_weight(r, kappa), last);
      last = lorentzian_weight(r, kappa);
    }
  }
}

TEST(Horizontal, WithoutMatchesNothingMoves) {
  HorizontalScene scene;
  for (Match& match : scene.source.matches) match.found = false;
  const auto sum = horizontal_equations(scene.source, scene.T, scene.config.horizontal, Workers(1));
  EXPECT_EQ(sum.count, 0);
  EXPECT_EQ(sum.solve(), Eigen::Vector3d::Zero());
  EXPECT_EQ(sum.rms(), 0.0);
}

TEST(Horizontal, ADirectionThatNothingConstrainsStays) {
  NormalEquations<3> sum;
  const Eigen::Matrix<double, 1, 3> J(1.0, 1.0, 0.0);
  sum.add<1>(J, Eigen::Matrix<double, 1, 1>(2.0), 1.0);
  // The least-norm solution of dx + dy = -2.
  EXPECT_LT((sum.solve() - Eigen::Vector3d(-1.0, -1.0, 0.0)).norm(), 1e-12);
}

TEST(Coupled, PointToPointEqualsTheDenseSumWithItsFourBlocks) {
  HorizontalScene scene;
  scene.config.registration.coupled_residual = Residual::point_to_point;
  Matrix6 H = Matrix6::Zero();
  Twist g = Twist::Zero();
  for (const DenseRow& row : dense_rows(scene)) {
    const double w = paper_weight(row.r.norm(), scene.config.horizontal.kernel_scale);
    H += w * row.J.transpose() * row.J;
    g += w * row.J.transpose() * row.r;
  }
  const auto sum = coupled_equations(scene.source, scene.map, scene.T, scene.config, Workers(1));
  EXPECT_LT((sum.H - H).norm(), 1e-10 * H.norm());
  EXPECT_LT((sum.g - g).norm(), 1e-10 * g.norm());

  // Eq. (4): in horizontal-vertical order the blocks give the same update, by elimination.
  Eigen::Matrix<double, 6, 6> order = Eigen::Matrix<double, 6, 6>::Zero();
  const int places[] = {0, 1, 5, 2, 3, 4};
  for (int i = 0; i < 6; ++i) order(i, places[i]) = 1.0;
  const Matrix6 blocks = order * H * order.transpose();
  const Twist g_HV = order * g;
  const Eigen::Matrix3d HH = blocks.topLeftCorner<3, 3>(), HV = blocks.topRightCorner<3, 3>();
  const Eigen::Matrix3d VH = blocks.bottomLeftCorner<3, 3>(), VV = blocks.bottomRightCorner<3, 3>();
  EXPECT_GT(HV.norm(), 1.0);  // the coupling that the paper removes is there
  const Eigen::Matrix3d schur = HH - HV * VV.inverse() * VH;
  Twist expected;
  expected.head<3>() = -schur.inverse() * (g_HV.head<3>() - HV * VV.inverse() * g_HV.tail<3>());
  expected.tail<3>() = -VV.inverse() * (g_HV.tail<3>() + VH * expected.head<3>());
  EXPECT_LT((order * sum.solve() - expected).norm(), 1e-9);
}

TEST(Coupled, PointToPlaneEqualsTheDenseSum) {
  HorizontalScene scene;
  scene.config.registration.coupled_residual = Residual::point_to_plane;
  Matrix6 H = Matrix6::Zero();
  Twist g = Twist::Zero();
  std::size_t next = 0;
  const auto rows = dense_rows(scene);
  for (std::size_t i = 0; i < scene.source.points.size(); ++i) {
    if (!scene.source.matches[i].found) continue;
    const DenseRow& row = rows[next++];
    const Eigen::Vector3d place = scene.T * scene.source.points[i].cast<double>();
    const Surface surface = scene.map.surface(scene.map.voxel_of(place));
    if (surface.neighbours < scene.config.vertical.min_neighbours) continue;
    const Eigen::Matrix<double, 1, 6> J = surface.normal.transpose() * row.J;
    const double r = surface.normal.dot(row.r);
    const double w = paper_weight(std::abs(r), scene.config.horizontal.kernel_scale);
    H += w * J.transpose() * J;
    g += w * J.transpose() * r;
  }
  const auto sum = coupled_equations(scene.source, scene.map, scene.T, scene.config, Workers(1));
  EXPECT_LT((sum.H - H).norm(), 1e-9 * H.norm());
  EXPECT_LT((sum.g - g).norm(), 1e-9 * g.norm());
}

}  // namespace
}  // namespace surefoot
