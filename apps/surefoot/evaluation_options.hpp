// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The flags that say how trajectories are compared with their truth, for every command that does.
#pragma once

#include <CLI/App.hpp>

#include "evaluation/evaluate.hpp"

namespace surefoot::app {

/// How poses are paired: --pair, --max-diff, --max-gap, --offset.
void add_pairing_options(CLI::App& command, evaluation::AssociationOptions& options);
/// Alignment, stretches of the relative error, segments. The values that `options` comes with are
/// the defaults. It must live until the command line is parsed.
void add_error_options(CLI::App& command, evaluation::EvaluationOptions& options);

}  // namespace surefoot::app
