// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The files of an ablation or a sweep, beside those of the comparison that it stands on.
#pragma once

#include <string>

#include "experiments/ablation_plan.hpp"
#include "experiments/compare_results.hpp"
#include "experiments/comparison_options.hpp"
#include "experiments/sweep.hpp"

namespace surefoot::experiments {

/// Into the folder of the comparison. @returns the table, as Markdown. Throws io::WriteError.
std::string write_ablation(const CompareOptions& options, const std::string& method,
                           const AblationPlan& plan, const CompareResults& results);
std::string write_sweep(const CompareOptions& options, const SweepPlan& plan,
                        const CompareResults& results);

}  // namespace surefoot::experiments
