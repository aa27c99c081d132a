// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "methods/knots/knot_registration.hpp"
#include "methods/knots/usual_size.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// How much more the sums of neighbours' residuals vary than they would were all residuals
/// independent, along each of the sensor's axes: in a corridor the few that hold it along the way
/// share errors that those of the walls do not. docs/method.md.
class Dependence {
 public:
  /// `unknown`: so many residuals count as one until anything was learnt.
  explicit Dependence(double unknown) : factors_(Twist::Constant(unknown)), mean_(unknown) {}

  /// A covariance of independent residuals, in the map's axes, of a sensor turned by `rotation`, as
  /// residuals depend on each other.
  [[nodiscard]] Matrix6 applied(const Matrix6& covariance,
                                const Eigen::Quaterniond& rotation) const;
  /// From a registration; `rate`: of the fading means.
  void learn(const KnotRegistration& found, const Eigen::Quaterniond& rotation, double rate);

  /// Along and about the sensor's axes: so many residuals count as one.
  [[nodiscard]] const Twist& factors() const { return factors_; }
  /// One for all axes; what all scans err by alike is in it.
  [[nodiscard]] double mean() const { return mean_; }

 private:
  using Neighbours = std::vector<std::array<Twist, 3>>;

  void learn_mean(const KnotRegistration& found, double rate);
  Matrix6 fluctuation_of(const Neighbours& sums, const Eigen::Quaterniond& rotation, double rate);

  UsualSize usual_size_;
  // Fading means in the sensor's axes, of scans of that size.
  Neighbours usual_;                       // gradients of neighbours, by segment
  Matrix6 fluctuation_ = Matrix6::Zero();  // outer products of what they differ by from these
  Matrix6 independent_ = Matrix6::Zero();  // what those would be of independent residuals
  Matrix6 information_ = Matrix6::Zero();
  int learnt_ = 0;
  Twist factors_;
  double mean_;
};

}  // namespace surefoot
