// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_prior.hpp"

namespace surefoot {

namespace {

// [m/s, rad/s] What a walker may do of whom nothing is known: standard deviations.
const Twist kUnknownVelocity = (Twist() << 1.0, 1.0, 0.3, 0.5, 0.5, 0.7).finished();
// Of the first pose, which defines the map's frame: as good as fixed, and still invertible.
constexpr double kFixed = 1e-3;  // [m, rad]

}  // namespace

void KnotPrior::add_to(BandedSystem& system, const KnotWindow& window) const {
  Eigen::Matrix<double, 12, 1> e;
  e << difference(window.knots[0], means[0]), difference(window.knots[1], means[1]);
  const Eigen::Matrix<double, 12, 1> gradient = information * e;  // [K8]
  system.add(0, 0, information.topLeftCorner<6, 6>());
  system.add(1, 0, information.bottomLeftCorner<6, 6>());
  system.add(1, 1, information.bottomRightCorner<6, 6>());
  system.add(0, gradient.head<6>());
  system.add(1, gradient.tail<6>());
}

double KnotPrior::surprise(const KnotWindow& window) const {
  Eigen::Matrix<double, 12, 1> e;
  e << difference(window.knots[0], means[0]), difference(window.knots[1], means[1]);
  return e.dot(information * e) / 12.0;
}

const Twist& unknown_velocity() { return kUnknownVelocity; }

KnotPrior at_rest(const Pose& pose, double step, double since) {
  KnotPrior prior{{pose, pose}, {}};
  const Matrix6 velocity = (kUnknownVelocity * step).cwiseAbs2().cwiseInverse().asDiagonal();
  prior.information << velocity, -velocity, -velocity, velocity;
  const Twist known = Twist::Constant(kFixed) + since * kUnknownVelocity;
  prior.information.topLeftCorner<6, 6>().diagonal() += known.cwiseAbs2().cwiseInverse();
  return prior;
}

}  // namespace surefoot
