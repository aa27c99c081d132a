// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "knots/knot_registration.hpp"

namespace surefoot {

/// What all registrations of a scan have in common.
struct KnotProblem {
  const SurfelMap& map;
  const KnotPrior& prior;
  const VelocityModel& model;
  const Config::Knots& config;
  const Workers& workers;
  const StepObserver& begin_step;
};

/// What registrations of the last scans ended with: fading means.
struct UsualFit {
  double misfit = 1.0;        ///< KnotRegistration::misfit
  double disagreement = 1.0;  ///< the same, with little weight on what the map has not seen

  void learn(const KnotRegistration& found, double rate);
  /// A registration whose misfit is larger is wrong.
  [[nodiscard]] double most_misfit() const;
};

/// The best of as many registrations as the scan needs. Most need one. One that ends worse than
/// usual is tried again from several motions: a map has many wrong places where a scan almost fits.
/// docs/method.md, "Convergence".
/// @param points of the scan; their places in the map are left as the last attempt found them
/// @param predicted the knots as the velocity model expects them
[[nodiscard]] KnotRegistration register_in_attempts(KnotPoints& points, const KnotProblem& problem,
                                                    const KnotWindow& predicted,
                                                    const UsualFit& usual);

}  // namespace surefoot
