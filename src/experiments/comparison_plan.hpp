// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The runs of a comparison in the order in which they are done and counted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/compare_inputs.hpp"
#include "experiments/comparison_options.hpp"
#include "experiments/method_variant.hpp"

namespace surefoot::experiments {

struct PlannedRun {
  std::size_t input = 0, variant = 0;  ///< by their numbers, from 0
  int repeat = 1;
};

/// Every recording by every method as often as asked for, whether it can be run or not. The repeats
/// are the outermost loop: what disturbs the machine for a while does not meet all repeats of one
/// run.
[[nodiscard]] std::vector<PlannedRun> plan_runs(std::size_t inputs, std::size_t variants,
                                                int repeats);
[[nodiscard]] std::vector<PlannedRun> share_of(const std::vector<PlannedRun>& runs,
                                               const ComparePart& part);

/// A line of JSON for each run: "part" of as many as there are runs, "recording", "method",
/// "repeat" and the "folder" within the comparison's.
[[nodiscard]] std::string runs_text(const std::vector<PlannedRun>& runs,
                                    const std::vector<CompareInput>& inputs,
                                    const std::vector<MethodVariant>& variants);

}  // namespace surefoot::experiments
