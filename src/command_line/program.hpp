// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What all programs of ours do with their command line, and with what goes wrong.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace surefoot::command_line {

/// Parses, runs the sub-command that is named, and says in one line why it could not. What main()
/// returns; `exit_code` is what the sub-command has set.
[[nodiscard]] int run_program(CLI::App& app, const std::string& version, int argc, char** argv,
                              const int& exit_code);

}  // namespace surefoot::command_line
