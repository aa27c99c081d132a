// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/config_text.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "runs/config_file.hpp"
#include "runs/run_yaml.hpp"

namespace surefoot::runs {

namespace {

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string escape_bars(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\\');
  }
  return text;
}

}  // namespace

std::string config_text(const Config& config) {
  std::string text;
  for (const ParameterInfo& info : parameters()) {
    if (!reads_parameter(config, info.name)) continue;
    text += fmt::format("{} = {}\n    {}\n    range: {}; default: {}; from: {}\n", info.name,
                        with_unit(get_parameter(config, info.name), info.unit), info.help,
                        with_unit(info.range, info.unit), info.default_value, info.source);
  }
  return text;
}

std::string config_yaml(const std::string& method, const Config& config) {
  YAML::Emitter out;
  emit_parameters(out, parameter_texts(config));
  return fmt::format("method: {}\n{}\n", method, out.c_str());
}

std::string config_page() {
  std::string page =
      "# Parameters\n\n"
      "Made by `surefoot config --markdown`; a test holds this page to the program.\n"
      "A parameter is set in a YAML file (`--config FILE`; `surefoot config --yaml --method NAME` "
      "writes one),\n"
      "or by `--set name=value`.\n"
      "\"sweep\" in the last column: chosen by the sweeps of [sweeps.md](sweeps.md).\n\n"
      "| parameter | default | unit | range | meaning | from |\n|---|---|---|---|---|---|\n";
  for (const ParameterInfo& info : parameters()) {
    page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", info.name, info.default_value,
                        info.unit, escape_bars(info.range), escape_bars(info.help), info.source);
  }
  return page;
}

}  // namespace surefoot::runs
