// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot config: every parameter of a method with default, unit, range, meaning and source.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "runs/config_text.hpp"

namespace surefoot::app {

namespace {

struct Options {
  std::string method = "surefoot";
  bool markdown = false;
  bool yaml = false;
};

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
    fmt::print("{}", options->markdown ? runs::config_page()
                     : options->yaml   ? runs::config_yaml(options->method, config)
                                       : runs::config_text(config));
  });
}

}  // namespace surefoot::app
