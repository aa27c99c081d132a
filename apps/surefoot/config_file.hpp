// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parameters from YAML and back.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surefoot/config.hpp"

namespace YAML {
class Emitter;
}

namespace surefoot::app {

/// The `method` that a file of parameters or a run.yaml names; empty if it names none. Throws
/// ConfigError naming the file.
[[nodiscard]] std::string method_of_file(const std::filesystem::path& path);

/// Sets the parameters that a YAML file names: nested maps (deskew: {segments: 4}) or dotted keys.
/// Of a run.yaml only its `parameters` are read; `method` is left to method_of_file(). Throws
/// ConfigError naming the file and the key.
void load_config_file(const std::filesystem::path& path, Config& config);

/// Sets parameters from "key=value" texts. Throws ConfigError.
void apply_settings(const std::vector<std::string>& settings, Config& config);

/// All parameters as nested YAML maps, which load_config_file takes back.
void emit_parameters(YAML::Emitter& out, const Config& config);

}  // namespace surefoot::app
