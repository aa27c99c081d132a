// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <vector>

#include "experiments/compare_results.hpp"

namespace surefoot::app {

/// Adds the flags; `options` must live until the command line is parsed.
void add_compare_options(CLI::App& command, experiments::CompareOptions& options);
/// The flags of whatever runs methods on recordings: all but --methods, --no-map.
void add_shared_options(CLI::App& command, experiments::CompareOptions& options);

/// Does the runs and hands on what they come to; with --part the runs alone, with --list-runs
/// neither. @returns the exit code.
[[nodiscard]] int run_comparison(
    const experiments::CompareOptions& options,
    const std::vector<experiments::MethodVariant>& variants,
    const std::function<void(const experiments::CompareResults& results)>& write);

}  // namespace surefoot::app
