// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Poses as 4x4 arrays and back.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>

#include "bindings.hpp"
#include "surefoot/pose.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::python {

/// Row by row, as numpy has them.
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

[[nodiscard]] inline Matrix4 matrix_of(const Pose& pose) { return pose.matrix(); }
/// Throws std::invalid_argument for what is no rigid motion.
[[nodiscard]] Pose pose_of(const Matrix4& matrix);

/// A Trajectory that pybind11 does not turn into a list.
struct NamedTrajectory {
  surefoot::Trajectory poses;
};

}  // namespace surefoot::python
