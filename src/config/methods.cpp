// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "config/method.hpp"

namespace surefoot {

namespace {

constexpr const char* kReadByAll[] = {"preprocess.",           "level.",
                                      "health.min_matches",    "health.min_match_ratio",
                                      "health.max_correction", "health.max_correction_deg"};

/// Names: of groups ("knots.") or single parameters ("map.radius").
bool is_among(std::string_view parameter, std::span<const char* const> names) {
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return name.ends_with('.') ? parameter.starts_with(name) : parameter == name;
  });
}

bool has_field(std::span<const ConfigField> fields, std::string_view name) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const ConfigField& field) { return name == field.name; });
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all = [] {
    std::vector<Preset> result;
    for (const Method* method : registered_methods()) {
      for (Preset& preset : method->presets()) result.push_back(std::move(preset));
    }
    return result;
  }();
  return all;
}

}  // namespace

const Method& find_method(std::string_view name) {
  std::string known;
  for (const Method* method : registered_methods()) {
    if (name == method->name) return *method;
    known += (known.empty() ? "" : ", ") + std::string(method->name);
  }
  throw ConfigError("Config::method: there is no '" + std::string(name) + "'; there are: " + known +
                    "; method_config() knows their variants");
}

bool reads_parameter(const Config& config, std::string_view name) {
  const Method& method = find_method(config.method);
  if (has_field(method.fields, name)) return true;
  if (!has_field(config_fields(), name) || is_among(name, method.does_not_read)) return false;
  return is_among(name, kReadByAll) || is_among(name, method.also_reads);
}

const std::vector<std::string>& methods() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Preset& preset : presets()) result.push_back(preset.name);
    return result;
  }();
  return names;
}

Config method_config(std::string_view method) {
  for (const Preset& preset : presets()) {
    if (preset.name == method) return preset.config;
  }
  std::string known;
  for (const std::string& name : methods()) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError("there is no method '" + std::string(method) + "'; there are: " + known);
}

}  // namespace surefoot
