// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/alignment.hpp"

#include <Eigen/Cholesky>

#include "geometry/so3.hpp"

namespace surefoot {

PointToPointSum& PointToPointSum::operator+=(const PointToPointSum& other) {
  weight += other.weight;
  weighted_squares += other.weighted_squares;
  count += other.count;
  s += other.s;
  ss += other.ss;
  r += other.r;
  sxr += other.sxr;
  return *this;
}

NormalEquations<6> PointToPointSum::equations() const {
  NormalEquations<6> result;
  result.H.topLeftCorner<3, 3>() = weight * Eigen::Matrix3d::Identity();
  result.H.topRightCorner<3, 3>() = -hat(s);
  result.H.bottomLeftCorner<3, 3>() = hat(s);
  result.H.bottomRightCorner<3, 3>() = ss.trace() * Eigen::Matrix3d::Identity() - ss;
  result.g << r, sxr;
  result.weight = weight;
  result.weighted_squares = weighted_squares;
  result.count = count;
  return result;
}

Twist solve_ldlt(const NormalEquations<6>& equations) {
  return equations.H.ldlt().solve(-equations.g);
}

}  // namespace surefoot
