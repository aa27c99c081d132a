// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What compare and ablate have in common: variants of methods on recordings with truth, each run a
// process of its own, none done twice.
#pragma once

#include <optional>
#include <vector>

#include "compare_inputs.hpp"
#include "compare_options.hpp"
#include "compare_results.hpp"
#include "method_variant.hpp"

namespace surefoot::app {

constexpr int kSomeFailed = 1;
constexpr int kInterrupted = 130;  // what shells give for Ctrl-C

/// The recordings; suites are made first where they are not there yet. Nothing if that was
/// interrupted, which is said. Throws std::runtime_error.
[[nodiscard]] std::optional<std::vector<CompareInput>> prepare_inputs(
    const CompareOptions& options);

/// Does the runs that are not done yet and evaluates all. Nothing if that was interrupted, which is
/// said. Throws ConfigError for a variant that cannot be, std::runtime_error.
[[nodiscard]] std::optional<CompareResults> run_comparison(
    const CompareOptions& options, const std::vector<CompareInput>& inputs,
    const std::vector<MethodVariant>& variants);

/// 0, or kSomeFailed if a run failed or repeats differ.
[[nodiscard]] int exit_code_of(const evaluation::Comparison& comparison);

}  // namespace surefoot::app
