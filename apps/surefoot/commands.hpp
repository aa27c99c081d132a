// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One function a sub-command, one file each. A function adds its sub-command to the program and
// does the work in CLI11's callback; an exception becomes a message and exit code 2 in main(),
// `exit_code` is for work that finished and has something to tell.
#pragma once

#include <CLI/App.hpp>

namespace surefoot::app {

void add_run_command(CLI::App& app, int& exit_code);
void add_live_command(CLI::App& app, int& exit_code);  // with SUREFOOT_PCAP
void add_map_command(CLI::App& app, int& exit_code);
void add_reference_command(CLI::App& app, int& exit_code);
void add_merge_command(CLI::App& app, int& exit_code);
void add_export_command(CLI::App& app, int& exit_code);
void add_info_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_datasets_command(CLI::App& app, int& exit_code);
void add_convert_command(CLI::App& app, int& exit_code);
void add_config_command(CLI::App& app, int& exit_code);
void add_simulate_command(CLI::App& app, int& exit_code);  // with SUREFOOT_SIMULATION
void add_suite_command(CLI::App& app, int& exit_code);     // with SUREFOOT_SIMULATION
void add_eval_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_ablate_command(CLI::App& app, int& exit_code);
void add_manual_command(CLI::App& app, int& exit_code);
void add_report_command(CLI::App& app, int& exit_code);
void add_sweep_command(CLI::App& app, int& exit_code);

}  // namespace surefoot::app
