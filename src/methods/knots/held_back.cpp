// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/held_back.hpp"

#include <algorithm>

#include "methods/knots/knot_window.hpp"

namespace surefoot {

namespace {

// [rad/s] The tilt's fluctuation at which poses are off by as much as they are held back. A smooth
// ride is off by less, a run by more: its velocity fluctuates more than the model takes it to.
constexpr double kAsMuch = 0.5, kLeast = 0.1;

// The usual counts as so many of this pose's own.
constexpr double kUsual = 0.5;

// The mean fades so much slower than the usual square.
constexpr double kSlower = 0.5;

}  // namespace

Matrix6 HeldBack::covariance(const Twist& held_back, const Twist& fluctuation,
                             const Eigen::Quaterniond& rotation) const {
  Matrix6 turn = Matrix6::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = rotation.toRotationMatrix();
  const double tilt = std::max({fluctuation[3], fluctuation[4], kLeast});
  const Twist own = held_back - turn * mean_;
  // [K23]
  return tilt / kAsMuch * (own * own.transpose() + kUsual * turn * usual_ * turn.transpose());
}

void HeldBack::learn(const Twist& held_back, const Eigen::Quaterniond& rotation, double rate) {
  const Twist own = rotated(rotation.conjugate(), held_back) - mean_;
  usual_ += rate * (own * own.transpose() - usual_);
  if (!counts_mean_) mean_ += kSlower * rate * own;
}

}  // namespace surefoot
