// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Dense systems of any size, to compare with: compiled once, since each decomposition of Eigen's
// takes a compiler seconds wherever it is used.
#pragma once

#include <Eigen/Core>

namespace surefoot::test {

/// x of H x = b, H symmetric and positive definite.
[[nodiscard]] Eigen::VectorXd solve(const Eigen::MatrixXd& H, const Eigen::VectorXd& b);
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);
/// error^T covariance^-1 error.
[[nodiscard]] double normalised_square(const Eigen::VectorXd& error,
                                       const Eigen::MatrixXd& covariance);

}  // namespace surefoot::test
