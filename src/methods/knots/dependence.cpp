// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/dependence.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "geometry/se3.hpp"
#include "geometry/triangular_solves.hpp"

namespace surefoot {

namespace {

// What is usual of the neighbours' sums fades so much slower than what they differ by from it.
constexpr double kUsualFades = 0.5;

double variance_of(const KnotRegistration& found) {
  return found.rigid.weighted_squares / std::max(found.rigid.count, 1);
}

/// What six degrees of freedom have been fitted to varies less than it would have.
double freedom_of(const KnotRegistration& found) {
  const double sums = 3.0 * static_cast<double>(found.neighbours.size());
  return sums / std::max(sums - 6.0, 1.0);
}

}  // namespace

Matrix6 Dependence::applied(const Matrix6& covariance, const Eigen::Quaterniond& rotation) const {
  const Matrix6 turn = turned_axes(rotation);
  const Twist scale = factors_.cwiseSqrt();
  const Matrix6 own = turn.transpose() * covariance * turn;
  return turn * scale.asDiagonal() * own * scale.asDiagonal() * turn.transpose();
}

/// What the sums differ by from what they usually are: an error that all scans share moves all of
/// them alike, and no motion between two of them.
Matrix6 Dependence::fluctuation_of(const Neighbours& sums, const Eigen::Quaterniond& rotation,
                                   double rate) {
  const double slower = std::max(kUsualFades * rate, 1.0 / (learnt_ + 1.0));
  Matrix6 products = Matrix6::Zero();
  for (std::size_t s = 0; s < sums.size(); ++s) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Twist own = rotated(rotation.conjugate(), sums[s][axis]) - usual_[s][axis];
      products += own * own.transpose();
      usual_[s][axis] += slower * own;
    }
  }
  return products;
}

void Dependence::learn_mean(const KnotRegistration& found, double rate) {
  const Eigen::LDLT<Matrix6> solver(found.rigid.H);
  if (solver.info() != Eigen::Success || !solver.isPositive()) return;
  Matrix6 products = Matrix6::Zero();
  for (const auto& segment : found.neighbours) {
    for (const Twist& gradient : segment) products += gradient * gradient.transpose();
  }
  const double ratio =
      freedom_of(found) * solve(solver, products).trace() / (6.0 * variance_of(found));
  if (std::isfinite(ratio)) mean_ += rate * (ratio - mean_);
}

void Dependence::learn(const KnotRegistration& found, const Eigen::Quaterniond& rotation,
                       double rate) {
  const double variance = variance_of(found);
  if (variance <= 0.0) return;
  learn_mean(found, rate);
  if (!usual_size_.takes(found.neighbours.size())) return;
  if (usual_.size() != found.neighbours.size()) {
    usual_.assign(found.neighbours.size(), {Twist::Zero(), Twist::Zero(), Twist::Zero()});
    learnt_ = 0;
  }
  ++learnt_;
  const Matrix6 turn = turned_axes(rotation);
  const Matrix6 information = turn.transpose() * found.rigid.H * turn;
  const double fades = std::max(rate, 1.0 / learnt_);
  const Matrix6 fluctuation = freedom_of(found) * fluctuation_of(found.neighbours, rotation, rate);
  fluctuation_ += fades * (fluctuation - fluctuation_);
  independent_ += fades * (variance * information - independent_);
  information_ += fades * (information - information_);
  const Eigen::LDLT<Matrix6> solver(information_);
  if (solver.info() != Eigen::Success || !solver.isPositive()) return;
  const auto spread = [&solver](const Matrix6& products) -> Twist {
    return solve(solver, Matrix6(solve(solver, products).transpose())).diagonal();
  };
  const Twist ratio = spread(fluctuation_).cwiseQuotient(spread(independent_));  // [K21]
  if (ratio.allFinite() && ratio.minCoeff() > 0.0) factors_ = ratio;
}

}  // namespace surefoot
