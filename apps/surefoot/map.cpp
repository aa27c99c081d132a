// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot map: a run that closes loops.
#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "run_command.hpp"
#include "run_options.hpp"

namespace surefoot::app {

void add_map_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<runs::RunOptions>();
  CLI::App* command = app.add_subcommand(
      "map", "Turn a recording into a map that knows where the robot came back: loops closed");
  command->add_option("input", options->input,
                      "what surefoot run reads; default: that of --config's run.yaml");
  add_run_options(*command, *options);
  command
      ->add_option("--loop-candidates", options->loop_candidates,
                   "places that are compared with each piece of way, those that look most alike")
      ->check(CLI::Range(1, 40))
      ->capture_default_str();
  command->add_flag("--no-loops", options->no_loops, "find loops, but move nothing")
      ->excludes("--map")
      ->excludes("--loop-closure");
  command->callback([command, options, &exit_code] {
    options->loop_closure = options->save_map = true;
    exit_code = run_recording(*command, *options);
  });
}

}  // namespace surefoot::app
