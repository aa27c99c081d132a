// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot_ros1: surefoot live as a node of ROS 1.
#include <CLI/CLI.hpp>

#include "command_line/program.hpp"
#include "commands.hpp"
#include "process/build_version.hpp"
#include "process/exit_codes.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Surefoot as a node of ROS 1"};
  int exit_code = surefoot::process::kDone;
  surefoot::app::add_live_command(app, exit_code);
  return surefoot::command_line::run_program(app, surefoot::process::build_version(), argc, argv,
                                             exit_code);
}
