// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a run was told besides its parameters, from the command line into run.yaml and back.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "runs/run_yaml.hpp"

namespace surefoot::app {

/// The options that were given. Names of files become absolute paths.
[[nodiscard]] runs::OptionTexts recorded_options(const CLI::App& command);

/// If `file` is a run.yaml: gives the command the options that it tells and the command line does
/// not, and `input` the run's recording if it is empty. @returns what was taken, to be told. Throws
/// io::ReadError, ConfigError, also where `run` is to repeat what another command has made.
std::string restore_options(CLI::App& command, const std::filesystem::path& file,
                            std::filesystem::path& input);

}  // namespace surefoot::app
