// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "experiments/comparison_options.hpp"

namespace surefoot::app {

/// Adds the flags; `options` must live until the command line is parsed.
void add_compare_options(CLI::App& command, experiments::CompareOptions& options);
/// The flags of whatever runs methods on recordings: all but --methods, --no-map.
void add_shared_options(CLI::App& command, experiments::CompareOptions& options);

}  // namespace surefoot::app
