// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/knots/dependence.hpp"
#include "methods/knots/held_back.hpp"
#include "methods/knots/knot_registration.hpp"
#include "methods/knots/velocity_model.hpp"
#include "surefoot/config.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// What a registered scan is told as.
struct ToldScan {
  ScanTrajectory trajectory;  ///< let go of; the map and what is expected next do not rely on it
  Matrix6 covariance = Matrix6::Zero();  ///< of its middle's pose, and of the motion since others
  double deviation = 0.0;  ///< [m] of the worst position, with what all scans err by alike
};

/// How far registrations are off, and what of it is known: the noise of residuals that depend on
/// each other, and what the velocity model holds back of a gait. Learnt while it walks.
/// docs/method.md, "The covariance" and "Let go".
class ErrorModel {
 public:
  explicit ErrorModel(const Config::Knots& config);

  /// `trajectory`: as registered.
  [[nodiscard]] ToldScan tell(const KnotRegistration& found, const ScanTrajectory& trajectory,
                              const VelocityModel& model) const;
  /// From a trusted registration, of its map the `agreed`-th.
  void learn(const KnotRegistration& found, const ScanTrajectory& trajectory, int agreed);

 private:
  double independence_, usual_rate_;
  Dependence dependence_;
  HeldBack held_back_{HeldBack::Mean::left_out};
  HeldBack held_back_in_all_{HeldBack::Mean::counted};
};

}  // namespace surefoot
