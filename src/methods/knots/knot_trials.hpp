// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "methods/knots/knot_registration.hpp"

namespace surefoot {

/// Registrations by some of a scan's points: where a start leads and, roughly, how well the scan
/// fits there, for a part of what a registration costs. Each is one thread's work, so that several
/// can go on at once.
class KnotTrials {
 public:
  KnotTrials(const KnotPoints& points, const Config::Knots& config);

  /// As register_knots(), but by one thread, and until the kernel has narrowed and a little longer:
  /// where it leads is seen then, whether it converges is not asked.
  /// @param problem its config and its workers are not used
  [[nodiscard]] KnotRegistration run(const KnotProblem& problem, const KnotWindow& start,
                                     const Annealing& annealing, const Abandon& abandon = {}) const;
  /// By one look from where a registration ended, how much of these points disagrees there.
  [[nodiscard]] double disagreement_at(const KnotWindow& window, const KnotProblem& problem) const;
  /// KnotRegistration::disagreement() by the same config.
  [[nodiscard]] double disagreement(const KnotRegistration& found) const {
    return found.disagreement(config_.unseen_weight);
  }

 private:
  KnotTrials(const KnotPoints& points, const Config::Knots& config, std::size_t stride);
  [[nodiscard]] KnotRegistration register_from(const KnotWindow& start, const KnotProblem& problem,
                                               const Annealing& annealing,
                                               const Abandon& abandon) const;

  KnotPoints points_;
  Config::Knots config_;
  Workers alone_{1};
};

}  // namespace surefoot
