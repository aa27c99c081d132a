// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a parameter's value does to the error: one changed at a time, against the method as it is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "experiments/method_variant.hpp"

namespace surefoot::experiments {

/// The method as it is, then one change after the other.
struct SweepPlan {
  std::vector<MethodVariant> variants;
  std::vector<std::string> labels;  ///< "knots.segments = 4"
};

/// `variations`: "key=value,value" or, for evenly spaced numbers, "key=first:last:step". Whether
/// there is such a parameter is seen by variant_config(). Throws ConfigError.
[[nodiscard]] SweepPlan sweep_plan(const std::string& method,
                                   const std::vector<std::string>& variations);

/// How one variant did on one recording.
struct SweepCell {
  std::optional<double> ape = {};   ///< [m] RMSE after alignment
  std::optional<double> step = {};  ///< [m] RMSE of the motion from scan to scan, if there is one
  std::string lost;                 ///< why there are no such figures; empty if there are
};

struct SweepRow {
  std::string label;
  std::vector<SweepCell> cells = {};  ///< one a recording
  /// Geometric means against the first row, over the recordings that neither has lost.
  std::optional<double> ape_ratio = {}, step_ratio = {};
  /// Median time per scan, mean over the whole runs; none without any.
  std::optional<double> milliseconds = {};
  std::size_t untrusted = 0;  ///< scans without a measured pose
};

struct SweepResult {
  std::vector<std::string> recordings;
  std::vector<SweepRow> rows;      ///< the method as it is first
  std::vector<std::string> notes;  ///< what went wrong in which run, and why
};

/// From a comparison of the plan's variants, whose relative error is that of one step.
[[nodiscard]] SweepResult sweep_of(const evaluation::Comparison& comparison,
                                   const std::vector<std::string>& labels);

/// The table, and the notes under it.
[[nodiscard]] std::string sweep_markdown(const SweepResult& sweep);
/// A line for each variant and recording.
[[nodiscard]] std::string sweep_csv(const SweepResult& sweep);
[[nodiscard]] std::string sweep_json(const SweepResult& sweep,
                                     const evaluation::Comparison& comparison);

}  // namespace surefoot::experiments
