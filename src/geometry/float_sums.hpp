// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Sums over three floats in one order on every machine. Eigen's own depends on whether it has
// vectors of two floats, as it does on ARM and not on x86-64: the last bit differs.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace surefoot {

[[nodiscard]] inline float dot(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return a.x() * b.x() + (a.y() * b.y() + a.z() * b.z());
}

[[nodiscard]] inline float squared_norm(const Eigen::Vector3f& v) { return dot(v, v); }

[[nodiscard]] inline float norm(const Eigen::Vector3f& v) { return std::sqrt(squared_norm(v)); }

[[nodiscard]] inline Eigen::Vector3f product(const Eigen::Matrix3f& matrix,
                                             const Eigen::Vector3f& v) {
  return {dot(matrix.row(0), v), dot(matrix.row(1), v), dot(matrix.row(2), v)};
}

}  // namespace surefoot
