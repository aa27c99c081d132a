// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/banded_system.hpp"

#include <algorithm>

#include "geometry/triangular_solves.hpp"

namespace surefoot {

namespace {
constexpr std::size_t kBand = 2;  // blocks below the diagonal
}

BandedSystem::BandedSystem(std::size_t poses) : blocks_(poses), gradient_(poses, Twist::Zero()) {
  for (auto& column : blocks_) column.fill(Matrix6::Zero());
}

void BandedSystem::add(const BandedSystem& other, double factor) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    for (std::size_t d = 0; d <= kBand; ++d) blocks_[i][d] += factor * other.blocks_[i][d];
    gradient_[i] += factor * other.gradient_[i];
  }
}

void BandedSystem::add_at(std::size_t first, const BandedSystem& other) {
  for (std::size_t i = 0; i < other.blocks_.size(); ++i) {
    for (std::size_t d = 0; d <= kBand; ++d) blocks_[first + i][d] += other.blocks_[i][d];
    gradient_[first + i] += other.gradient_[i];
  }
}

Matrix6 BandedSystem::Covariance::at(const std::pair<std::size_t, double>& place) const {
  const auto [a, u] = place;
  const Matrix6 between = (*this)(a, a + 1);
  // [K20]
  return (1.0 - u) * (1.0 - u) * (*this)(a, a) + u * u * (*this)(a + 1, a + 1) +
         u * (1.0 - u) * (between + between.transpose());
}

BandedSystem::Covariance BandedSystem::Covariance::part(std::size_t first,
                                                        std::size_t count) const {
  Covariance result;
  const auto begin = blocks_.begin() + static_cast<std::ptrdiff_t>(first);
  result.blocks_.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
  return result;
}

bool BandedSystem::factorise() {
  const std::size_t n = blocks_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::LLT<Matrix6> llt(blocks_[i][0]);
    if (llt.info() != Eigen::Success || !blocks_[i][0].allFinite()) return false;
    blocks_[i][0] = llt.matrixL();
    const std::size_t below = std::min(kBand, n - 1 - i);
    for (std::size_t d = 1; d <= below; ++d) {  // L_ji = H_ji L_ii^-T
      solve_from_right(blocks_[i][0], blocks_[i][d]);
    }
    for (std::size_t a = 1; a <= below; ++a) {
      for (std::size_t b = a; b <= below; ++b) {
        blocks_[i + a][b - a].noalias() -= blocks_[i][b] * blocks_[i][a].transpose();
      }
    }
  }
  return true;
}

std::vector<Twist> BandedSystem::solve() const {  // [K10]
  const std::size_t n = blocks_.size();
  std::vector<Twist> x(n);
  for (std::size_t i = 0; i < n; ++i) {
    Twist right = -gradient_[i];
    for (std::size_t d = 1; d <= std::min(kBand, i); ++d) right -= blocks_[i - d][d] * x[i - d];
    x[i] = blocks_[i][0].triangularView<Eigen::Lower>().solve(right);
  }
  for (std::size_t i = n; i-- > 0;) {
    Twist right = x[i];
    for (std::size_t d = 1; d <= std::min(kBand, n - 1 - i); ++d) {
      right -= blocks_[i][d].transpose() * x[i + d];
    }
    x[i] = blocks_[i][0].triangularView<Eigen::Lower>().transpose().solve(right);
  }
  return x;
}

Eigen::Matrix<double, 12, 12> BandedSystem::last_two_information() const {
  const auto& before = blocks_[blocks_.size() - 2];
  Eigen::Matrix<double, 12, 12> L = Eigen::Matrix<double, 12, 12>::Zero();
  L.topLeftCorner<6, 6>() = before[0].triangularView<Eigen::Lower>();
  L.bottomLeftCorner<6, 6>() = before[1];
  L.bottomRightCorner<6, 6>() = blocks_.back()[0].triangularView<Eigen::Lower>();
  return L.lazyProduct(
      L.transpose());  // in one order on every machine, as a product by blocks is not
}

BandedSystem::Covariance BandedSystem::covariance() const {
  const std::size_t n = blocks_.size();
  Covariance Z;
  Z.blocks_.resize(n);
  for (std::size_t i = n; i-- > 0;) {
    const Matrix6 inverse = blocks_[i][0].triangularView<Eigen::Lower>().solve(Matrix6::Identity());
    const std::size_t below = std::min(kBand, n - 1 - i);
    // Z L = L^-T, read off column i; the columns after it are known.
    for (std::size_t d = 1; d <= below; ++d) {
      Matrix6 sum = Matrix6::Zero();
      for (std::size_t e = 1; e <= below; ++e) sum += Z(i + d, i + e) * blocks_[i][e];
      Z.blocks_[i][d] = -sum * inverse;
    }
    Matrix6 diagonal = inverse.transpose();
    for (std::size_t e = 1; e <= below; ++e) {
      diagonal -= Z.blocks_[i][e].transpose() * blocks_[i][e];
    }
    // Read as symmetric below: what is not would grow along the chain without bound.
    const Matrix6 block = diagonal * inverse;
    Z.blocks_[i][0] = 0.5 * (block + block.transpose());
  }
  return Z;
}

}  // namespace surefoot
