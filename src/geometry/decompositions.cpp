// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace surefoot {

template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& H) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(H);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix<double, 3, 3>&);
template SymmetricEigen<6> symmetric_eigen<6>(const Eigen::Matrix<double, 6, 6>&);

SymmetricEigen<3> symmetric_eigen_direct(const Eigen::Matrix3d& H) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(H);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Svd svd(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> solver(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {solver.matrixU(), solver.matrixV(), solver.singularValues()};
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  auto [U, V, values] = svd(matrix);
  if ((U * V.transpose()).determinant() < 0.0) U.col(2) *= -1.0;
  return U * V.transpose();
}

}  // namespace surefoot
