// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Decompositions of small matrices, compiled here once: each of Eigen's takes a compiler seconds in
// every source that asks for it.
#pragma once

#include <Eigen/Core>

namespace surefoot {

/// H = vectors * diag(values) * vectors^T of a symmetric H.
template <int Size>
struct SymmetricEigen {
  Eigen::Matrix<double, Size, 1> values;      // ascending
  Eigen::Matrix<double, Size, Size> vectors;  // columns, of length 1
};
template <int Size>  // 3 or 6
[[nodiscard]] SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& H);
extern template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix<double, 3, 3>&);
extern template SymmetricEigen<6> symmetric_eigen<6>(const Eigen::Matrix<double, 6, 6>&);
/// In closed form, without a function of a library's: faster, the same bits everywhere, and where
/// two values nearly agree as right as where none do. For the surfaces of a map, of which there are
/// many.
[[nodiscard]] SymmetricEigen<3> symmetric_eigen_direct(const Eigen::Matrix3d& H);
/// Likewise of (xx xy; xy yy).
[[nodiscard]] SymmetricEigen<2> symmetric_eigen_direct(double xx, double xy, double yy);

/// matrix = U * diag(values) * V^T, values descending.
struct Svd {
  Eigen::Matrix3d U, V;
  Eigen::Vector3d values;
};
[[nodiscard]] Svd svd(const Eigen::Matrix3d& matrix);

/// The rotation with the least sum of squared differences from the matrix; never a reflection.
[[nodiscard]] Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace surefoot
