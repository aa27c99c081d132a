// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "geometry/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace surefoot {

template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& H) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(H);
  return {solver.eigenvalues(), solver.eigenvectors()};
}
template SymmetricEigen<3> symmetric_eigen<3>(const Eigen::Matrix<double, 3, 3>&);
template SymmetricEigen<6> symmetric_eigen<6>(const Eigen::Matrix<double, 6, 6>&);

SymmetricEigen<2> symmetric_eigen_direct(double xx, double xy, double yy) {
  const double middle = 0.5 * (xx + yy), half = 0.5 * (xx - yy);
  const double wide = std::sqrt(half * half + xy * xy);  // libm's hypot is another elsewhere
  // The axis of the larger value, by the form that is a sum.
  Eigen::Vector2d axis =
      half > 0.0 ? Eigen::Vector2d(half + wide, xy) : Eigen::Vector2d(xy, wide - half);
  const double length = axis.norm();
  axis = length > 0.0 ? Eigen::Vector2d(axis / length) : Eigen::Vector2d::UnitX();
  SymmetricEigen<2> result;
  result.values << middle - wide, middle + wide;
  result.vectors << -axis.y(), axis.x(), axis.x(), axis.y();
  return result;
}

namespace {

constexpr double kNothing = 1e-70;  // its fourth power is hardly a number any more

/// c with 4 c^3 - 3 c = r for r from 0 to 1: the cosine of a third of an angle. Newton's steps from
/// what is right to 4e-05.
double third_of_cosine(double r) {
  double c = 0.866062 + r * (0.165405 + r * (-0.040881 + r * 0.009444));
  for (int i = 0; i < 2; ++i) c -= ((4.0 * c * c - 3.0) * c - r) / (12.0 * c * c - 3.0);
  return c;
}

/// The longest of the vectors, with length 1.
Eigen::Vector3d longest(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c) {
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), cc = c.squaredNorm();
  const bool b_first = bb > aa;
  const double ab = b_first ? bb : aa;
  const bool c_first = cc > ab;
  const double scale = 1.0 / std::sqrt(c_first ? cc : ab);
  Eigen::Vector3d result;
  for (int i = 0; i < 3; ++i) result[i] = scale * (c_first ? c[i] : b_first ? b[i] : a[i]);
  return result;
}

}  // namespace

/// The value that lies apart from the other two, in units of p about their mean, is 2 c or -2 c;
/// what is left across its vector is a problem of two dimensions.
SymmetricEigen<3> symmetric_eigen_direct(const Eigen::Matrix3d& H) {
  const double mean = (H(0, 0) + H(1, 1) + H(2, 2)) * (1.0 / 3.0);
  const double xx = H(0, 0) - mean, yy = H(1, 1) - mean, zz = H(2, 2) - mean;
  const double xy = H(1, 0), xz = H(2, 0), yz = H(2, 1);
  const double p =
      std::sqrt((xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz)) * (1.0 / 6.0));
  if (!(p > kNothing)) {
    return {Eigen::Vector3d::Constant(mean), Eigen::Matrix3d::Identity()};
  }
  const double det = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  const double r = std::clamp(0.5 * det / (p * p * p), -1.0, 1.0);
  const double apart = std::copysign(2.0 * p * third_of_cosine(std::abs(r)), r);

  const Eigen::Vector3d x(xx - apart, xy, xz), y(xy, yy - apart, yz), z(xz, yz, zz - apart);
  const Eigen::Vector3d axis = longest(x.cross(y), y.cross(z), z.cross(x));
  // Two more across it, after Duff et al., "Building an Orthonormal Basis, Revisited" (2017).
  const double sign = std::copysign(1.0, axis.z()), a = -1.0 / (sign + axis.z());
  const double b = axis.x() * axis.y() * a;
  const Eigen::Vector3d u(1.0 + sign * axis.x() * axis.x() * a, sign * b, -sign * axis.x());
  const Eigen::Vector3d v(b, sign + axis.y() * axis.y() * a, -axis.y());
  const auto times = [&](const Eigen::Vector3d& w) {
    return Eigen::Vector3d(xx * w.x() + xy * w.y() + xz * w.z(),
                           xy * w.x() + yy * w.y() + yz * w.z(),
                           xz * w.x() + yz * w.y() + zz * w.z());
  };
  const Eigen::Vector3d Hu = times(u), Hv = times(v);
  const SymmetricEigen<2> rest = symmetric_eigen_direct(u.dot(Hu), u.dot(Hv), v.dot(Hv));

  SymmetricEigen<3> result;
  const int at = r < 0.0 ? 0 : 2, low = r < 0.0 ? 1 : 0;
  result.values[at] = mean + apart;
  result.vectors.col(at) = axis;
  for (int i = 0; i < 2; ++i) {
    result.values[low + i] = mean + rest.values[i];
    result.vectors.col(low + i) = rest.vectors(0, i) * u + rest.vectors(1, i) * v;
  }
  return result;
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
