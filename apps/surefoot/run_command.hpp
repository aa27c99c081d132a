// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "runs/run_options.hpp"

namespace surefoot::app {

/// What `surefoot run` and `surefoot map` do: runs the odometry, says what came of it and returns
/// the exit code.
int run_recording(CLI::App& command, runs::RunOptions& options);

}  // namespace surefoot::app
