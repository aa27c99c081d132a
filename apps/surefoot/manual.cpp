// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot manual: manual pages and shell completion.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "command_line/manual_page.hpp"
#include "commands.hpp"

namespace surefoot::app {

void add_manual_command(CLI::App& app, int&) {
  struct Arguments {
    std::string command;
    bool completion = false;
    bool list = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("manual", "Print a manual page, or a shell's completion");
  command->group("");  // for packages, not for users
  command->add_option("command", arguments->command, "whose page; none: the program's");
  command->add_flag("--completion", arguments->completion, "for bash");
  command->add_flag("--list", arguments->list, "the commands that have pages");
  command->callback([arguments, &app] {
    const command_line::ProgramNames names = {
        "surefoot", "Surefoot", "LiDAR odometry for robots that walk", SUREFOOT_VERSION};
    if (arguments->completion) {
      fmt::print("{}", command_line::bash_completion(app, names));
    } else if (!arguments->list) {
      fmt::print("{}", command_line::manual_page(app, names, arguments->command));
    } else {
      for (const CLI::App* one : command_line::listed_commands(app)) {
        fmt::print("{}\n", one->get_name());
      }
    }
  });
}

}  // namespace surefoot::app
