// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/segment_rows.hpp"

namespace surefoot {

namespace {

// Scale of the Geman-McClure kernel in standard deviations of a residual: the usual three.
constexpr float kKernelSigmas = 3.0F;

}  // namespace

const SegmentSums& SegmentRows::sums() {
  if (rows_ > 0) sum_up();
  return sums_;
}

void SegmentRows::sum_up() {
  weight_.tail(kRows - rows_).setZero();
  part_.tail(kRows - rows_).setZero();
  const auto value = columns_.col(kValue);
  // [K4]
  const Column cauchy =
      1.0F / (1.0F + value.square() / (kKernelSigmas * kKernelSigmas * variance_));
  const Column w = weight_ * cauchy.square() / variance_;
  sums_.misfit += static_cast<double>((part_ * (1.0F - cauchy)).sum());
  sums_.weight += static_cast<double>(w.sum());
  sums_.weighted_squares += static_cast<double>((w * value.square()).sum());
  sums_.squared_distance += static_cast<double>((w * squared_distance_).sum());
  sums_.count += rows_;
  add_products(w);
  if (neighbours_) add_neighbours(w);
  rows_ = 0;
}

/// Of the whole block: what is not filled has no weight.
void SegmentRows::add_products(const Column& w) {
  Eigen::Array<float, kRows, 3> shares;
  shares << (1.0F - u_) * (1.0F - u_) * w, u_ * (1.0F - u_) * w, u_ * u_ * w;  // [K3]
  Eigen::Matrix<double, 7, 7> products[3];  // their lower triangles
  for (int i = 0; i < 7; ++i) {
    const Eigen::Array<float, kRows, 3> weighted = shares.colwise() * columns_.col(i);
    for (int j = 0; j <= i; ++j) {
      for (int k = 0; k < 3; ++k) {
        products[k](i, j) = static_cast<double>((weighted.col(k) * columns_.col(j)).sum());
      }
    }
  }
  const std::array<Matrix6*, 3> blocks = {&sums_.first, &sums_.between, &sums_.last};
  for (int k = 0; k < 3; ++k) {
    const Matrix6 H = products[k].topLeftCorner<6, 6>().selfadjointView<Eigen::Lower>();
    *blocks[static_cast<std::size_t>(k)] += H;
  }
  const auto gradient = [&](int k) { return products[k].row(kValue).head<6>().transpose(); };
  sums_.first_gradient += gradient(0) + gradient(1);  // 1 - u is (1 - u)^2 + u (1 - u)
  sums_.last_gradient += gradient(1) + gradient(2);
}

void SegmentRows::add_neighbours(const Column& w) {
  for (int row = 0; row < rows_; ++row) {
    int axis = 0;
    columns_.row(row).head<3>().abs().maxCoeff(&axis);
    sums_.neighbours[static_cast<std::size_t>(axis)] +=
        (w[row] * columns_(row, kValue) * columns_.row(row).head<6>())
            .matrix()
            .transpose()
            .cast<double>();
  }
}

}  // namespace surefoot
