// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A method as the configuration sees it. Each describes itself in its folder, in X_method.cpp;
// methods/registry.cpp lists them all.
#pragma once

#include <any>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/config_fields.hpp"

namespace surefoot {

class FrontEnd;
struct Session;

/// A named set of parameters: one of methods().
struct Preset {
  std::string name;
  Config config;
};

struct Method {
  /// Config::method, and the name of the first preset.
  const char* name = "";
  /// The parameters that are its own.
  std::span<const ConfigField> fields = {};
  /// The struct that these lie in, to be put into Config::others; null: they lie in Config itself.
  std::any (*make_parameters)() = nullptr;
  /// What else it reads besides preprocess, level and health: groups ("motion_prior.") or single
  /// parameters ("map.radius"),
  std::span<const char* const> also_reads = {};
  /// and of these, what it does not.
  std::span<const char* const> does_not_read = {};
  /// Throws ConfigError if values contradict each other; null: none can.
  void (*check)(const Config& config) = nullptr;
  std::vector<Preset> (*presets)() = nullptr;
  std::unique_ptr<FrontEnd> (*make_front_end)(const Session& session) = nullptr;
};

/// All methods, in the order in which their presets are listed.
[[nodiscard]] std::span<const Method* const> registered_methods();
/// The tables of all parameters, in the order in which they are printed.
[[nodiscard]] std::vector<std::span<const ConfigField>> field_tables();

/// Throws ConfigError naming the methods there are.
[[nodiscard]] const Method& find_method(std::string_view name);

/// A method's own struct in a Config.
template <typename Parameters>
[[nodiscard]] const Parameters& own_parameters(const Config& config) {
  for (const std::any& each : config.others) {
    if (const auto* found = std::any_cast<Parameters>(&each)) return *found;
  }
  throw std::logic_error("a Config that was moved from has no parameters");
}
template <typename Parameters>
[[nodiscard]] Parameters& own_parameters(Config& config) {
  return const_cast<Parameters&>(own_parameters<Parameters>(std::as_const(config)));
}

}  // namespace surefoot
