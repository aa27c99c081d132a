// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Systems of six by six, and sums of three floats, against Eigen's.
#include "geometry/triangular_solves.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "geometry/float_sums.hpp"

namespace surefoot {
namespace {

class TriangularSolvesTest : public testing::Test {
 protected:
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Matrix6 matrix() {
    Matrix6 any;
    for (double& value : any.reshaped()) value = number();
    return any;
  }
  /// With what must not be read above its diagonal.
  Matrix6 lower() {
    Matrix6 L = matrix();
    L.diagonal().array() += 3.0;
    L.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
    return L;
  }

  std::mt19937 random_{3};
};

TEST_F(TriangularSolvesTest, WhatIsSolvedIsWhatWasAskedFor) {
  for (int i = 0; i < 20; ++i) {
    const Matrix6 stored = lower(), B = matrix();
    const Matrix6 L = stored.triangularView<Eigen::Lower>();
    const Matrix6 ones = stored.triangularView<Eigen::UnitLower>();
    Matrix6 X = B;
    solve_lower(stored, Diagonal::given, X);
    EXPECT_TRUE((L * X).isApprox(B, 1e-12));
    X = B;
    solve_lower(stored, Diagonal::ones, X);
    EXPECT_TRUE((ones * X).isApprox(B, 1e-12));
    X = B;
    solve_upper(stored, Diagonal::given, X);
    EXPECT_TRUE((L.transpose() * X).isApprox(B, 1e-12));
    X = B;
    solve_upper(stored, Diagonal::ones, X);
    EXPECT_TRUE((ones.transpose() * X).isApprox(B, 1e-12));
    X = B;
    solve_from_right(stored, X);
    EXPECT_TRUE((X * L.transpose()).isApprox(B, 1e-12));
  }
}

TEST_F(TriangularSolvesTest, DecomposedMatricesAreInverted) {
  const Matrix6 A = matrix(), B = matrix();
  const Matrix6 H = A * A.transpose() + Matrix6::Identity();
  EXPECT_TRUE((H * solve(Eigen::LDLT<Matrix6>(H), B)).isApprox(B, 1e-12));
  EXPECT_TRUE(inverse(Eigen::LLT<Matrix6>(H)).isApprox(H.inverse(), 1e-12));
}

TEST_F(TriangularSolvesTest, ADirectionThatNothingIsKnownOfIsLeftOut) {
  Matrix6 H = Matrix6::Identity();
  H(2, 2) = 0.0;
  const Matrix6 X = solve(Eigen::LDLT<Matrix6>(H), Matrix6::Constant(2.0));
  EXPECT_TRUE(X.row(2).isZero());
  EXPECT_DOUBLE_EQ(X.sum(), 2.0 * 5 * 6);
}

TEST_F(TriangularSolvesTest, ThreeFloatsAreSummedFromTheEnd) {
  // In this order alone the small ones are not lost.
  const Eigen::Vector3f v(1.0F, 0x1p-24F, 0x1p-24F);
  EXPECT_EQ(dot(v, Eigen::Vector3f::Ones()), 1.0F + 0x1p-23F);
  EXPECT_EQ(product(v * Eigen::RowVector3f(1, 0, 0), {2.0F, 1.0F, 1.0F}), Eigen::Vector3f(2 * v));
  EXPECT_FLOAT_EQ(squared_norm({1.0F, 2.0F, 3.0F}), 14.0F);
  EXPECT_FLOAT_EQ(norm({2.0F, 3.0F, 6.0F}), 7.0F);
}

}  // namespace
}  // namespace surefoot
