// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "command_line/program.hpp"
#include "commands.hpp"
#include "process/build_version.hpp"
#include "process/exit_codes.hpp"

namespace {

void add_commands(CLI::App& app, int& exit_code) {
  using namespace surefoot::app;
  add_run_command(app, exit_code);
#ifdef SUREFOOT_HAS_PCAP
  add_live_command(app, exit_code);
#endif
  add_map_command(app, exit_code);
  add_reference_command(app, exit_code);
  add_merge_command(app, exit_code);
  add_export_command(app, exit_code);
  add_info_command(app, exit_code);
  add_check_command(app, exit_code);
  add_convert_command(app, exit_code);
  add_datasets_command(app, exit_code);
  add_eval_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_ablate_command(app, exit_code);
  add_report_command(app, exit_code);
  add_sweep_command(app, exit_code);
  add_config_command(app, exit_code);
  add_manual_command(app, exit_code);
#ifdef SUREFOOT_HAS_SIMULATION
  add_simulate_command(app, exit_code);
  add_suite_command(app, exit_code);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Surefoot: LiDAR odometry for robots that walk"};
  int exit_code = surefoot::process::kDone;
  add_commands(app, exit_code);
  return surefoot::command_line::run_program(app, surefoot::process::build_version(), argc, argv,
                                             exit_code);
}
