// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "methods/knots/knot_registration.hpp"

namespace surefoot {

/// What registrations of the last scans ended with: fading means.
struct UsualFit {
  double misfit = 1.0;        ///< KnotRegistration::misfit
  double disagreement = 1.0;  ///< KnotRegistration::disagreement()
  double misfit_of_seen = 1.0;
  int scans = 0;  ///< that it was learnt from

  /// `rate`: weight of this registration, 1 to forget all others.
  void learn(const KnotRegistration& found, double rate, const Config::Knots& config);
  /// A registration whose misfit to what the map has seen is larger is wrong.
  [[nodiscard]] double most_misfit_of_seen(const Config::Knots& config) const;
};

/// Whether a registration ended worse than usual, so that others are tried.
[[nodiscard]] bool is_suspicious(const KnotRegistration& found, const UsualFit& usual,
                                 const Config::Knots& config);

/// 1 where planes and poles hold a scan, less the more clouds do, 0 where these are half of its
/// matches and more.
[[nodiscard]] double firmness(const KnotRegistration& found);

/// From which segment on a scan's last ones fit worse than those before them: its end ran away
/// there, the motion within the scan having changed. Their number if none do.
/// @param disagreements of the segments
/// @param worse so many times, in the mean, or it is none
[[nodiscard]] std::size_t runs_away_from(const std::vector<double>& disagreements, double worse);

/// The best of as many registrations as the scan needs. Most need one. One that ends worse than
/// usual is tried again from several motions: a map has many wrong places where a scan almost fits.
/// docs/method.md, "Convergence".
/// @param points of the scan; their places in the map are left as the last attempt found them
/// @param predicted the knots as the velocity model expects them
[[nodiscard]] KnotRegistration register_in_attempts(KnotPoints& points, const KnotProblem& problem,
                                                    const KnotWindow& predicted,
                                                    const UsualFit& usual);

}  // namespace surefoot
