// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/held_back.hpp"

#include <algorithm>

#include "geometry/se3.hpp"
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

// How alike two scans in a row are held back is a fading mean at this rate, and is taken to be
// wholly until more than so many scans tell otherwise.
constexpr double kAlikeRate = 0.025, kDoubtful = 20.0;

// Poses whose neighbours are held back so much alike are not let go of.
constexpr double kAlike = 0.4;

}  // namespace

Matrix6 HeldBack::covariance(const Twist& held_back, const Twist& fluctuation,
                             const Eigen::Quaterniond& rotation) const {
  const Matrix6 turn = turned_axes(rotation);
  const double tilt = std::max({fluctuation[3], fluctuation[4], kLeast});
  const Twist own = held_back - turn * mean_;
  // [K23]
  return tilt / kAsMuch * (own * own.transpose() + kUsual * turn * usual_ * turn.transpose());
}

/// Of each of the sensor's axes [K38]. A map's unevenness holds neighbouring scans back alike, a
/// gait from scan to scan otherwise.
Twist HeldBack::shares() const {
  const double known = learnt_ / (learnt_ + kDoubtful);
  Twist shares;
  for (int axis = 0; axis < 6; ++axis) {
    const double seen = squares_[axis] > 0.0 ? products_[axis] / squares_[axis] : 1.0;
    const double alike = known * seen + 1.0 - known;
    shares[axis] = std::clamp(1.0 - alike / kAlike, 0.0, 1.0);
  }
  return shares;
}

Twist HeldBack::let_go(const Twist& held_back, const Eigen::Quaterniond& rotation) const {
  const Twist own = rotated(rotation.conjugate(), held_back) - mean_;
  return rotated(rotation, shares().cwiseProduct(own));
}

void HeldBack::learn(const Twist& held_back, const Eigen::Quaterniond& rotation, double rate) {
  const Twist own = rotated(rotation.conjugate(), held_back) - mean_;
  ++learnt_;
  const double alike_rate = std::max(kAlikeRate, 1.0 / learnt_);
  squares_ += alike_rate * (own.cwiseAbs2() - squares_);
  products_ += alike_rate * (own.cwiseProduct(last_) - products_);
  last_ = own;
  usual_ += rate * (own * own.transpose() - usual_);
  if (!counts_mean_) mean_ += kSlower * rate * own;
}

}  // namespace surefoot
