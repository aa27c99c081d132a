// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot config: every parameter of a method with default, unit, range, meaning and source.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <memory>

#include "commands.hpp"
#include "runs/config_file.hpp"
#include "runs/run_yaml.hpp"

namespace surefoot::app {

namespace {

struct Options {
  std::string method = "surefoot";
  bool markdown = false;
  bool yaml = false;
};

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

void print_text(const Config& config) {
  for (const ParameterInfo& info : parameters()) {
    if (!reads_parameter(config, info.name)) continue;
    fmt::print("{} = {}\n    {}\n    range: {}; default: {}; from: {}\n", info.name,
               with_unit(get_parameter(config, info.name), info.unit), info.help,
               with_unit(info.range, info.unit), info.default_value, info.source);
  }
}

std::string escape_bars(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, 1, '\\');
  }
  return text;
}

void print_markdown() {
  fmt::print(
      "# Parameters\n\n"
      "Made by `surefoot config --markdown`; a test holds this page to the program.\n"
      "A parameter is set in a YAML file (`--config`), or by `--set name=value`.\n"
      "\"sweep\" in the last column: chosen by the sweeps of [sweeps.md](sweeps.md).\n\n"
      "| parameter | default | unit | range | meaning | from |\n|---|---|---|---|---|---|\n");
  for (const ParameterInfo& info : parameters()) {
    fmt::print("| `{}` | {} | {} | {} | {} | {} |\n", info.name, info.default_value, info.unit,
               escape_bars(info.range), escape_bars(info.help), info.source);
  }
}

void print_yaml(const std::string& method, const Config& config) {
  YAML::Emitter out;
  runs::emit_parameters(out, runs::parameter_texts(config));
  fmt::print("method: {}\n{}\n", method, out.c_str());
}

}  // namespace

void add_config_command(CLI::App& app, int&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "config",
      "Print every parameter of a method with its value, unit, range, meaning and source");
  command->add_option("--method", options->method, "the method whose parameters are printed");
  CLI::Option* yaml =
      command->add_flag("--yaml", options->yaml, "as a file for `surefoot run --config`");
  command->add_flag("--markdown", options->markdown, "all of them, as the page docs/config.md")
      ->excludes(yaml);
  command->callback([options] {
    const Config config = method_config(options->method);
    if (options->markdown) {
      print_markdown();
    } else if (options->yaml) {
      print_yaml(options->method, config);
    } else {
      print_text(config);
    }
  });
}

}  // namespace surefoot::app
