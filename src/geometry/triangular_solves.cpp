// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/triangular_solves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

constexpr int kSize = 6;
constexpr int kBlock = 4;

}  // namespace

void solve_lower(const Matrix6& L, Diagonal diagonal, Matrix6& X) {
  for (int begin = 0; begin < kSize; begin += kBlock) {
    const int end = std::min(begin + kBlock, kSize);
    for (int column = 0; column < kSize; ++column) {
      for (int k = begin; k < end; ++k) {
        if (diagonal == Diagonal::given) X(k, column) *= 1.0 / L(k, k);
        for (int row = k + 1; row < end; ++row) X(row, column) -= X(k, column) * L(row, k);
      }
      for (int row = end; row < kSize; ++row) {
        double sum = 0.0;
        for (int k = begin; k < end; ++k) sum += L(row, k) * X(k, column);
        X(row, column) -= sum;
      }
    }
  }
}

void solve_upper(const Matrix6& L, Diagonal diagonal, Matrix6& X) {
  for (int end = kSize; end > 0; end -= kBlock) {
    const int begin = std::max(end - kBlock, 0);
    for (int column = 0; column < kSize; ++column) {
      for (int row = end - 1; row >= begin; --row) {
        double sum = 0.0;
        for (int k = row + 1; k < end; ++k) sum += L(k, row) * X(k, column);
        X(row, column) -= sum;
        if (diagonal == Diagonal::given) X(row, column) *= 1.0 / L(row, row);
      }
      for (int row = 0; row < begin; ++row) {
        double sum = 0.0;
        for (int k = begin; k < end; ++k) sum += L(k, row) * X(k, column);
        X(row, column) -= sum;
      }
    }
  }
}

void solve_from_right(const Matrix6& L, Matrix6& X) {
  for (int begin = 0; begin < kSize; begin += kBlock) {
    const int end = std::min(begin + kBlock, kSize);
    for (int column = begin; column < end; ++column) {
      if (begin > 0) {
        Eigen::Matrix<double, kSize, 1> sum = Eigen::Matrix<double, kSize, 1>::Zero();
        for (int k = 0; k < begin; ++k) sum += X.col(k) * L(column, k);
        X.col(column) -= sum;
      }
      for (int k = begin; k < column; ++k) X.col(column) -= X.col(k) * L(column, k);
      X.col(column) *= 1.0 / L(column, column);
    }
  }
}

Matrix6 solve(const Eigen::LDLT<Matrix6>& H, const Matrix6& B) {
  const Matrix6& L = H.matrixLDLT();
  Matrix6 X = H.transpositionsP() * B;
  solve_lower(L, Diagonal::ones, X);
  for (int row = 0; row < kSize; ++row) {
    const double D = L(row, row);
    if (std::abs(D) > std::numeric_limits<double>::min()) {
      X.row(row) /= D;
    } else {
      X.row(row).setZero();
    }
  }
  solve_upper(L, Diagonal::ones, X);
  return H.transpositionsP().transpose() * X;
}

Matrix6 inverse(const Eigen::LLT<Matrix6>& H) {
  const Matrix6& L = H.matrixLLT();
  Matrix6 X = Matrix6::Identity();
  solve_lower(L, Diagonal::given, X);
  solve_upper(L, Diagonal::given, X);
  return X;
}

}  // namespace surefoot
