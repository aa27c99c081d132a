// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "support/dense_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace surefoot::test {

Eigen::VectorXd solve(const Eigen::MatrixXd& H, const Eigen::VectorXd& b) {
  return H.ldlt().solve(b);
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) { return matrix.inverse(); }

double normalised_square(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance) {
  return error.dot(solve(covariance, error));
}

}  // namespace surefoot::test
