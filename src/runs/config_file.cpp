// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/config_file.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>

#include "runs/method_parameters.hpp"

namespace surefoot::runs {

namespace {

constexpr std::size_t kMostBytes = 1 << 20;

using Names = std::set<std::string>;

/// Which of two values is meant cannot be known.
void note_name(const std::string& name, const YAML::Node& node, Names& seen) {
  if (seen.insert(name).second) return;
  throw ConfigError(fmt::format("line {}: {} stands there twice", node.Mark().line + 1, name));
}

/// Files may tell all parameters of all methods, as older run.yamls do; what the method does not
/// read has to be what it is anyway.
void set_from_file(const std::string& name, const std::string& value, Config& config) {
  const Config before = config;
  set_parameter(config, name, value);
  if (get_parameter(before, name) != get_parameter(config, name)) {
    require_parameter(config, name);
  }
}

void apply_node(const YAML::Node& node, const std::string& prefix, Config& config, Names& seen) {
  if (!node.IsMap()) {
    throw ConfigError(fmt::format("line {}: expected a map of parameters", node.Mark().line + 1));
  }
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    const std::string name = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
    if (entry.second.IsMap()) {
      apply_node(entry.second, name, config, seen);
    } else if (entry.second.IsScalar()) {
      note_name(name, entry.first, seen);
      set_from_file(name, entry.second.Scalar(), config);
    } else {
      throw ConfigError(fmt::format("line {}: parameter {}: expected one value",
                                    entry.second.Mark().line + 1, name));
    }
  }
}

/// YAML is text; yaml-cpp takes bytes that are none for an empty file.
void check_text(std::string_view text) {
  const auto binary = std::find_if(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\n' && c != '\r' && c != '\t') || byte == 0x7F || byte == 0xFF ||
           byte == 0xFE;
  });
  if (binary == text.end()) return;
  throw ConfigError(fmt::format("not YAML: byte {:#04x} at {}, expected text",
                                static_cast<unsigned char>(*binary),
                                std::distance(text.begin(), binary)));
}

/// The whole file, which may be a pipe.
std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || !file.eof()) {
    throw ConfigError(file.gcount() > 0 ? "too long for a file of parameters"
                                        : "cannot be read; expected a YAML file of parameters");
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// What `read` and yaml-cpp throw, as a ConfigError that names the file.
void read_file(const std::filesystem::path& path,
               const std::function<void(const YAML::Node&)>& read) {
  try {
    const std::string text = text_of(path);
    check_text(text);
    const YAML::Node root = YAML::Load(text);
    if (!root.IsNull()) read(root);  // an empty file sets nothing
  } catch (const YAML::Exception& error) {
    throw ConfigError(path.string() + ": not YAML: " + error.what());
  } catch (const ConfigError& error) {
    throw ConfigError(path.string() + ": " + error.what());
  }
}

/// The entries at the top of the file. Throws ConfigError if one stands there twice.
void check_top(const YAML::Node& root) {
  Names seen;
  if (!root.IsMap()) return;
  for (const auto& entry : root) {
    if (entry.first.IsScalar()) note_name(entry.first.Scalar(), entry.first, seen);
  }
}

}  // namespace

std::string method_of_file(const std::filesystem::path& path) {
  std::string method;
  read_file(path, [&](const YAML::Node& root) {
    check_top(root);
    if (!root.IsMap() || !root["method"] || root["method"].IsNull()) return;
    method = root["method"].as<std::string>();
  });
  return method;
}

void load_config_file(const std::filesystem::path& path, Config& config) {
  read_file(path, [&](YAML::Node root) {
    check_top(root);
    if (root.IsMap()) root.remove("method");
    Names seen;
    apply_node(root.IsMap() && root["parameters"] ? root["parameters"] : root, "", config, seen);
  });
}

void apply_settings(const std::vector<std::string>& settings, Config& config) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw ConfigError("--set " + setting + ": expected key=value, as in preprocess.max_range=50");
    }
    set_parameter(config, setting.substr(0, equals), setting.substr(equals + 1));
    require_parameter(config, setting.substr(0, equals));
  }
}

void emit_parameters(YAML::Emitter& out,
                     const std::vector<std::pair<std::string, std::string>>& values) {
  const std::vector<ParameterInfo>& known = parameters();
  out << YAML::BeginMap;
  std::string open_group;
  for (const auto& [key, value] : values) {
    const std::string& name = key;  // clang takes no structured binding into a lambda
    const std::size_t dot = name.find('.');
    const std::string group = name.substr(0, dot);
    if (group != open_group) {
      if (!open_group.empty()) out << YAML::EndMap;
      out << YAML::Key << group << YAML::Value << YAML::BeginMap;
      open_group = group;
    }
    out << YAML::Key << name.substr(dot + 1) << YAML::Value << value;
    const auto info = std::find_if(known.begin(), known.end(),
                                   [&](const ParameterInfo& other) { return other.name == name; });
    if (info != known.end() && !info->unit.empty()) out << YAML::Comment(info->unit);
  }
  if (!open_group.empty()) out << YAML::EndMap;
  out << YAML::EndMap;
}

}  // namespace surefoot::runs
