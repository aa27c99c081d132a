// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "methods/knots/banded_system.hpp"
#include "methods/knots/knot_window.hpp"

namespace surefoot {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// What is known of the last scan's last two knots when the next scan begins: they are the means
/// of a Gaussian, over the differences (knot_window.hpp) of the one and the other.
struct KnotPrior {
  Pose means[2];
  Matrix12 information = Matrix12::Zero();

  /// Adds the terms that hold the window's first two knots to the means.
  void add_to(BandedSystem& system, const KnotWindow& window) const;
  /// How far they are from them: mean of the twelve squares, in standard deviations.
  [[nodiscard]] double surprise(const KnotWindow& window) const;
};

/// Standard deviations of the velocity of a walker of whom nothing is known [m/s, rad/s].
[[nodiscard]] const Twist& unknown_velocity();

/// Two knots at one pose, `step` [s] apart, of a sensor that may be walking already. The pose
/// defines the map's frame, or was known `since` [s] ago.
[[nodiscard]] KnotPrior at_rest(const Pose& pose, double step, double since = 0.0);

}  // namespace surefoot
