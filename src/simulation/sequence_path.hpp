// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where the LiDAR is while the lasers of one firing sequence fire one after the other.
#pragma once

#include <Eigen/Core>

#include "surefoot/pose.hpp"

namespace surefoot::simulation {

/// The parabola through the poses, as matrices, at the begin, the middle and the end of a firing
/// sequence: over 0.1 ms a walking body's pose differs from it by less than 1e-9 (m, and of a
/// matrix's elements).
class SequencePath {
 public:
  SequencePath() = default;
  SequencePath(const Pose& begin, const Pose& middle, const Pose& end)
      : begin_(matrix(begin)),
        bend_(2.0 * (begin_ - 2.0 * matrix(middle) + matrix(end))),
        slope_(matrix(end) - begin_ - bend_) {}

  /// [R | t] of T_map_lidar. @param share of the sequence's time, 0 at its begin, 1 at its end.
  [[nodiscard]] Eigen::Matrix<double, 3, 4> at(double share) const {
    return begin_ + share * (slope_ + share * bend_);
  }

 private:
  using Matrix = Eigen::Matrix<double, 3, 4>;

  static Matrix matrix(const Pose& pose) {
    return (Matrix() << pose.rotation.toRotationMatrix(), pose.translation).finished();
  }

  Matrix begin_ = Matrix::Identity(), bend_ = Matrix::Zero(), slope_ = Matrix::Zero();
};

}  // namespace surefoot::simulation
