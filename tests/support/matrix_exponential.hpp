// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Rigid motions by Eigen's general matrix functions (Pade, scaling and squaring): a formula that
// shares nothing with the library's.
#pragma once

#include <Eigen/Core>

#include "surefoot/pose.hpp"

namespace surefoot::test {

/// exp of the 4 x 4 matrix [[phi]_x rho; 0 0] of a twist [rho phi].
[[nodiscard]] Eigen::Matrix4d matrix_exponential(const Twist& twist);
/// exp of the 3 x 3 matrix [phi]_x.
[[nodiscard]] Eigen::Matrix3d rotation_exponential(const Eigen::Vector3d& rotation_vector);
/// Twist of log of a rigid motion's matrix; rotations below pi.
[[nodiscard]] Twist matrix_logarithm(const Eigen::Matrix4d& motion);

}  // namespace surefoot::test
