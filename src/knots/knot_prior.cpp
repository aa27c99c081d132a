// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/knot_prior.hpp"

namespace surefoot {

namespace {

// Standard deviations of the velocity of a walker of whom nothing is known.
const Twist kUnknownVelocity = (Twist() << 1.0, 1.0, 0.3, 0.5, 0.5, 0.7).finished();
constexpr double kFixed = 1e-3;  // [m, rad] of the first pose

}  // namespace

KnotPrior at_rest(const Pose& pose, double step, double since) {
  KnotPrior prior{{pose, pose}, {}};
  const Matrix6 velocity = (kUnknownVelocity * step).cwiseAbs2().cwiseInverse().asDiagonal();
  prior.information << velocity, -velocity, -velocity, velocity;
  const Twist known = Twist::Constant(kFixed) + since * kUnknownVelocity;
  prior.information.topLeftCorner<6, 6>().diagonal() += known.cwiseAbs2().cwiseInverse();
  return prior;
}

}  // namespace surefoot
