// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "geometry/decompositions.hpp"

namespace surefoot {

/// H = sum w J^T J and g = sum w J^T r of a weighted least-squares step, with what a report needs.
template <int Size>
struct NormalEquations {
  using Matrix = Eigen::Matrix<double, Size, Size>;
  using Vector = Eigen::Matrix<double, Size, 1>;

  Matrix H = Matrix::Zero();
  Vector g = Vector::Zero();
  double weight = 0.0;            // sum of w
  double weighted_squares = 0.0;  // sum of w |r|^2
  int count = 0;

  template <int Rows>
  void add(const Eigen::Matrix<double, Rows, Size>& J, const Eigen::Matrix<double, Rows, 1>& r,
           double w) {
    H.noalias() += w * (J.transpose() * J);
    g.noalias() += w * (J.transpose() * r);
    weight += w;
    weighted_squares += w * r.squaredNorm();
    ++count;
  }

  NormalEquations& operator+=(const NormalEquations& other) {
    H += other.H;
    g += other.g;
    weight += other.weight;
    weighted_squares += other.weighted_squares;
    count += other.count;
    return *this;
  }

  /// delta with H delta = -g. Directions that nothing constrains stay zero, so that a singular H
  /// moves nothing where it knows nothing.
  [[nodiscard]] Vector solve() const {
    constexpr double kSingular = 1e-10;  // of the largest eigenvalue: rounding, not information
    const SymmetricEigen<Size> eigen = symmetric_eigen(H);
    const double floor = kSingular * eigen.values[Size - 1];
    const Vector along = eigen.vectors.transpose() * g;
    Vector delta = Vector::Zero();
    for (int i = 0; i < Size; ++i) {
      const double value = eigen.values[i];
      if (value > floor) delta -= along[i] / value * eigen.vectors.col(i);
    }
    return delta;
  }

  /// Weighted RMS residual [m].
  [[nodiscard]] double rms() const {
    return weight > 0.0 ? std::sqrt(weighted_squares / weight) : 0.0;
  }
};

}  // namespace surefoot
