// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot reference: a run that every scan of the recording takes part in at once.
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "run_command.hpp"
#include "run_options.hpp"

namespace surefoot::app {

void add_reference_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<runs::RunOptions>();
  CLI::App* command = app.add_subcommand(
      "reference",
      "Turn a recording into a trajectory to hold others against: all scans at once, offline");
  command->add_option("input", options->input,
                      "what surefoot run reads; default: that of --config's run.yaml");
  add_run_options(*command, *options);
  command->remove_option(command->get_option("--method"));  // by Surefoot's own alone
  command->callback([command, options, &exit_code] {
    options->reference = true;
    exit_code = run_recording(*command, *options);
  });
}

}  // namespace surefoot::app
