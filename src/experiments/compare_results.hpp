// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// From the folders that the runs have left to the comparison: errors, verdicts, tables, figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "experiments/compare_inputs.hpp"
#include "experiments/comparison_options.hpp"
#include "experiments/method_variant.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::experiments {

/// The trajectories that the figures show: aligned as for the errors; empty where a run failed.
struct ComparedPaths {
  Trajectory truth;
  std::vector<Trajectory> estimates;  ///< one for each method
  /// Likewise: the poses with which another segment begins.
  std::vector<std::vector<std::size_t>> begins;
};

struct CompareResults {
  evaluation::Comparison comparison;
  std::vector<ComparedPaths> paths;  ///< one for each recording
  std::size_t failed = 0;            ///< of the runs that were asked for
};

/// runs/RECORDING/METHOD/REPEAT, relative to the comparison's folder; `repeat` from 1.
[[nodiscard]] std::filesystem::path run_folder(const CompareInput& input,
                                               const MethodVariant& variant, int repeat);

/// Reads the truth of a recording. Throws what says why it cannot be used.
[[nodiscard]] Trajectory read_truth(const CompareInput& input);

/// Evaluates all runs, anew each time. What cannot be read or evaluated is a failed run.
[[nodiscard]] CompareResults collect_results(const CompareOptions& options,
                                             const std::vector<CompareInput>& inputs,
                                             const std::vector<MethodVariant>& variants,
                                             const std::string& build);

/// compare.json, tables.md, tables.csv, tables.tex and the figures. Throws io::WriteError.
void write_results(const CompareOptions& options, const CompareResults& results);

}  // namespace surefoot::experiments
