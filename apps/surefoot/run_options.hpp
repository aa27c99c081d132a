// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "runs/run_options.hpp"

namespace surefoot::app {

/// Adds the flags of whatever runs the odometry, but where its scans come from; `options` must live
/// until the command line is parsed.
void add_run_options(CLI::App& command, runs::RunOptions& options);

}  // namespace surefoot::app
