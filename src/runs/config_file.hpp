// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parameters from YAML and back.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "surefoot/config.hpp"

namespace YAML {
class Emitter;
}

namespace surefoot::runs {

/// The `method` that a file of parameters or a run.yaml names; empty if it names none. Throws
/// ConfigError naming the file.
[[nodiscard]] std::string method_of_file(const std::filesystem::path& path);

/// Sets the parameters that a YAML file names: nested maps (deskew: {segments: 4}) or dotted keys.
/// Of a run.yaml only its `parameters` are read; `method` is left to method_of_file(). Throws
/// ConfigError naming the file and the key; also for a key that stands there twice, or that the
/// config's method does not read.
void load_config_file(const std::filesystem::path& path, Config& config);

/// Sets parameters from "key=value" texts. Throws ConfigError, also for what the config's method
/// does not read.
void apply_settings(const std::vector<std::string>& settings, Config& config);

/// Parameters' `values` (name, value) as nested YAML maps, which load_config_file takes back.
void emit_parameters(YAML::Emitter& out,
                     const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace surefoot::runs
