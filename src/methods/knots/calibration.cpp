// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/calibration.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

/// Standard deviations found, as multiples of those that were claimed.
struct Found {
  double along;   // the way, or turning about it
  double across;  // likewise
  double upright;
};
constexpr Found kTranslation{1.2, 0.75, 0.9};
constexpr Found kRotation{1.5, 1.1, 0.8};

constexpr double kWay = 0.1;  // [m/s] what is slower has no way: as along it, on all sides

// A variance grows with so much of a power of the tilt's fluctuation [rad/s], about a trot's.
constexpr double kTrot = 0.5, kLeast = 0.1, kPower = 0.25;

/// `left`: unit vector across the way, shorter where there is no way.
Eigen::Matrix3d scale(const Found& found, const Eigen::Vector3d& left) {
  const Eigen::Matrix3d level =
      Eigen::Vector3d(found.along, found.along, found.upright).asDiagonal();
  return level - (found.along - found.across) * left * left.transpose();
}

}  // namespace

Matrix6 calibrated(const Matrix6& covariance, const Twist& velocity, const Twist& fluctuation) {
  const Eigen::Vector3d left = Eigen::Vector3d(-velocity.y(), velocity.x(), 0.0) /
                               std::hypot(velocity.x(), velocity.y(), kWay);
  Matrix6 deviations = Matrix6::Zero();
  deviations.topLeftCorner<3, 3>() = scale(kTranslation, left);
  deviations.bottomRightCorner<3, 3>() = scale(kRotation, left);
  const double tilt = std::max({fluctuation[3], fluctuation[4], kLeast});
  // [K23]
  return std::pow(tilt / kTrot, kPower) * deviations * covariance * deviations;
}

}  // namespace surefoot
