// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/drift.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "methods/knots/knot_prior.hpp"

namespace surefoot {

namespace {

// What is wrong, as Estimate::wrong_probability says.
constexpr double kWrongDistance = 0.2, kWrongAngle = 3.0 * std::numbers::pi / 180.0;  // [m], [rad]

/// That a Gaussian of this deviation is farther off than this, on either side.
double beyond(double limit, double deviation) {
  return deviation > 0.0 ? std::erfc(limit / (deviation * std::numbers::sqrt2)) : 0.0;
}

}  // namespace

Drift drift_along(const std::vector<DegenerateDirection>& weak, double distance, double elapsed) {
  Drift drift;
  Twist metres = Twist::Ones();
  metres.tail<3>().setConstant(distance);
  Twist farthest = elapsed * unknown_velocity();
  farthest.tail<3>() = farthest.tail<3>().cwiseMin(std::numbers::pi);
  for (const DegenerateDirection& direction : weak) {
    const double speed =
        direction.direction.cwiseProduct(metres.cwiseProduct(unknown_velocity())).norm();  // [m/s]
    // [K32]
    const Twist along = speed * elapsed * direction.direction.cwiseQuotient(metres);
    const Twist off = along.cwiseMin(farthest).cwiseMax(-farthest);
    drift.covariance += off * off.transpose();
    drift.wrong_probability =
        std::max({drift.wrong_probability, beyond(kWrongDistance, off.head<3>().norm()),
                  beyond(kWrongAngle, off.tail<3>().norm())});
  }
  return drift;
}

}  // namespace surefoot
