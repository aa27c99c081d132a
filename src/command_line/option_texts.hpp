// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Options of a command as texts, to be kept and given again. Every option is covered, also those
// that are added some day, except the ones that are named.
#pragma once

#include <CLI/App.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace surefoot::command_line {

using GivenOptions = std::vector<std::pair<std::string, std::string>>;  ///< name, value
using OptionNames = std::span<const char* const>;                       ///< without dashes

/// The options that were given. Names of files (kFileType) become absolute paths.
[[nodiscard]] GivenOptions given_options(const CLI::App& command, OptionNames except);

/// Gives the command those that the command line does not. @returns which, as they would be
/// written. Throws std::invalid_argument for one that there is not, or a value that it refuses.
std::string give_options(CLI::App& command, const GivenOptions& options, OptionNames except);

}  // namespace surefoot::command_line
