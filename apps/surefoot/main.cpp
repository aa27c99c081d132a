// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "commands.hpp"

namespace {

constexpr int kBadInput = 2;

void add_commands(CLI::App& app, int& exit_code) {
  using namespace surefoot::app;
  add_run_command(app, exit_code);
  add_info_command(app, exit_code);
  add_eval_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_ablate_command(app, exit_code);
  add_report_command(app, exit_code);
  add_sweep_command(app, exit_code);
  add_config_command(app, exit_code);
#ifdef SUREFOOT_HAS_SIMULATION
  add_simulate_command(app, exit_code);
  add_suite_command(app, exit_code);
#endif
}

}  // namespace

// Exit codes: 0 done, 1 done but something failed that the output names, 2 wrong usage or bad
// input, 130 interrupted.
int main(int argc, char** argv) {
  CLI::App app{"Surefoot: LiDAR odometry for robots that walk"};
  app.set_version_flag("--version", SUREFOOT_VERSION);
  app.require_subcommand(1);
  int exit_code = 0;
  add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  } catch (const std::exception& error) {
    fmt::print(stderr, "surefoot: {}\n", error.what());
    return kBadInput;
  }
  return exit_code;
}
