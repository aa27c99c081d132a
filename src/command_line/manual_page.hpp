// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Manual pages and shell completion, made from the table of options that the command line itself is
// read by.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace surefoot::command_line {

/// What the pages call the program.
struct ProgramNames {
  std::string command;  ///< "surefoot"
  std::string title;    ///< "Surefoot"
  std::string purpose;
  std::string version;
};

/// The sub-commands that help shows.
[[nodiscard]] std::vector<const CLI::App*> listed_commands(const CLI::App& app);

/// The page of the program, in roff; of a sub-command where one is named. Throws
/// std::invalid_argument where there is none of that name.
[[nodiscard]] std::string manual_page(const CLI::App& app, const ProgramNames& names,
                                      const std::string& command = "");

/// For bash: options of a command, and for those of fixed words the words; files for all else.
[[nodiscard]] std::string bash_completion(const CLI::App& app, const ProgramNames& names);

}  // namespace surefoot::command_line
