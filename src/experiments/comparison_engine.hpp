// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What compare, ablate and sweep have in common: variants of methods on recordings with truth, each
// run a process of its own, none done twice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/compare_results.hpp"
#include "experiments/comparison_options.hpp"
#include "experiments/method_variant.hpp"

namespace surefoot::experiments {

/// Makes the suites that are not there yet, does the runs that are not done yet and evaluates all.
/// A recording whose truth cannot be read is told at once, and not run. With a part of the runs
/// nothing is evaluated. Nothing if it was interrupted, which is said. Throws ConfigError for a
/// variant that cannot be, std::runtime_error.
[[nodiscard]] std::optional<CompareResults> compare_variants(
    const CompareOptions& options, const std::vector<MethodVariant>& variants);

/// The runs that compare_variants() would do, a line of JSON each. Throws as that does, but makes
/// no suite and reads no truth.
[[nodiscard]] std::string list_runs(const CompareOptions& options,
                                    const std::vector<MethodVariant>& variants);

/// process::kDone, or kSomeFailed if a run failed or repeats differ.
[[nodiscard]] int exit_code_of(const CompareResults& results);

}  // namespace surefoot::experiments
