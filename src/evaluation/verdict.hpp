// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Whether an estimate may be compared by its errors at all. An estimate of the first half of a run
// has a small error, and no place in a ranking.
#pragma once

#include <string>

#include "evaluation/evaluate.hpp"

namespace surefoot::evaluation {

enum class Outcome {
  whole,     ///< covers the reference; the only one that is ranked
  stopped,   ///< ends before the reference does
  partial,   ///< reaches the end with too many holes
  diverged,  ///< no closer to the reference than an estimate that never moves
  failed     ///< no estimate that could be evaluated
};
/// The word for it in files: whole, stopped, partial, diverged or failed.
[[nodiscard]] std::string_view to_string(Outcome outcome);

struct RunVerdict {
  Outcome outcome = Outcome::failed;
  std::string text;  ///< for people: "stopped at 41 %"; empty for whole
};

struct VerdictRules {
  double full_coverage = 0.95;    ///< least share of the reference's time [0, 1] to be whole
  double standing_share = 0.9;    ///< of the error of standing still, from which on it is diverged
  double least_divergence = 1.0;  ///< [m] a smaller APE RMSE is never called diverged
};

/// The APE RMSE [m] that an estimate of one single place has after the best alignment: the spread
/// of the reference's positions about their mean.
[[nodiscard]] double standing_error(const Trajectory& reference);

/// Throws std::invalid_argument if one of the trajectories is empty.
[[nodiscard]] RunVerdict judge(const Trajectory& reference, const Trajectory& estimate,
                               const Evaluation& evaluation, const EvaluationOptions& options,
                               const VerdictRules& rules = {});

}  // namespace surefoot::evaluation
