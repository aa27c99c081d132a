// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <functional>

namespace surefoot::app {

namespace {

void apply_node(const YAML::Node& node, const std::string& prefix, Config& config) {
  if (!node.IsMap()) {
    throw ConfigError(fmt::format("line {}: expected a map of parameters", node.Mark().line + 1));
  }
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    const std::string name = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
    if (entry.second.IsMap()) {
      apply_node(entry.second, name, config);
    } else if (entry.second.IsScalar()) {
      set_parameter(config, name, entry.second.Scalar());
    } else {
      throw ConfigError(fmt::format("line {}: parameter {}: expected one value",
                                    entry.second.Mark().line + 1, name));
    }
  }
}

/// What `read` and yaml-cpp throw, as a ConfigError that names the file.
void read_file(const std::filesystem::path& path,
               const std::function<void(const YAML::Node&)>& read) {
  try {
    const YAML::Node root = YAML::LoadFile(path.string());
    if (!root.IsNull()) read(root);  // an empty file sets nothing
  } catch (const YAML::BadFile&) {
    throw ConfigError(path.string() + ": cannot be read; expected a YAML file of parameters");
  } catch (const YAML::Exception& error) {
    throw ConfigError(path.string() + ": not YAML: " + error.what());
  } catch (const ConfigError& error) {
    throw ConfigError(path.string() + ": " + error.what());
  }
}

}  // namespace

std::string method_of_file(const std::filesystem::path& path) {
  std::string method;
  read_file(path, [&](const YAML::Node& root) {
    if (root.IsMap() && root["method"]) method = root["method"].as<std::string>();
  });
  return method;
}

void load_config_file(const std::filesystem::path& path, Config& config) {
  read_file(path, [&](YAML::Node root) {
    if (root.IsMap()) root.remove("method");
    apply_node(root.IsMap() && root["parameters"] ? root["parameters"] : root, "", config);
  });
}

void apply_settings(const std::vector<std::string>& settings, Config& config) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw ConfigError("--set " + setting + ": expected key=value, as in deskew.segments=4");
    }
    set_parameter(config, setting.substr(0, equals), setting.substr(equals + 1));
  }
}

void emit_parameters(YAML::Emitter& out, const Config& config) {
  out << YAML::BeginMap;
  std::string open_group;
  for (const ParameterInfo& info : parameters()) {
    const std::size_t dot = info.name.find('.');
    const std::string group = info.name.substr(0, dot);
    if (group != open_group) {
      if (!open_group.empty()) out << YAML::EndMap;
      out << YAML::Key << group << YAML::Value << YAML::BeginMap;
      open_group = group;
    }
    out << YAML::Key << info.name.substr(dot + 1) << YAML::Value
        << get_parameter(config, info.name);
    if (!info.unit.empty()) out << YAML::Comment(info.unit);
  }
  out << YAML::EndMap << YAML::EndMap;
}

}  // namespace surefoot::app
