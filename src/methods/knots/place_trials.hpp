// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How well a scan fits at places of which only a coarse look told. docs/method.md, "Lost".
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/preprocess.hpp"
#include "methods/knots/knot_prediction.hpp"
#include "methods/knots/knot_trials.hpp"

namespace surefoot {

/// A scan that begins at a place of which nothing is known but what a coarse look told.
[[nodiscard]] KnotEnd begin_at(const Pose& place, const PreparedScan& scan,
                               const Config::Knots& config);

/// Where to try a scan: T_map_lidar as it begins, and its motion [m/s, rad/s, map's axes].
struct PlaceStart {
  Pose place;
  Twist velocity;
};

/// Where a trial ended.
struct PlaceTrial {
  KnotEnd begin;
  KnotWindow predicted, window;
  Pose pose;  ///< of the scan's middle
  double disagreement = 1.0;
  double unseen = 1.0;  ///< KnotRegistration::unseen
};

/// Tries a scan at several places, each by some of its points.
class PlaceTrials {
 public:
  /// What is referred to outlives it.
  /// @param problem its prior is not used
  PlaceTrials(const PreparedScan& scan, const std::vector<std::uint32_t>& chosen,
              const KnotProblem& problem);

  /// How much of these points disagrees where a registration ended.
  [[nodiscard]] double disagreement_at(const KnotWindow& window) const;
  /// Where the starts lead: best first, of those that end at one place the best; not those that are
  /// going to disagree far more than `least`, or with no solution.
  [[nodiscard]] std::vector<PlaceTrial> from(
      const std::vector<PlaceStart>& starts,
      double least = std::numeric_limits<double>::infinity()) const;

 private:
  [[nodiscard]] std::optional<PlaceTrial> run(PlaceTrial trial, double least) const;

  const PreparedScan& scan_;
  const std::vector<std::uint32_t>& chosen_;
  const KnotProblem& problem_;
  KnotTrials trials_;
};

}  // namespace surefoot
