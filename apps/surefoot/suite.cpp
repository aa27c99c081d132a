// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot suite: the fixed set of recordings that tables stand on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "recordings/suite_maker.hpp"
#include "simulation/standard_suite.hpp"

namespace surefoot::app {

namespace {

struct SuiteOptions {
  recordings::SuiteRequest request;
  bool quiet = false;
};

int make(const SuiteOptions& options) {
  const process::InterruptGuard guard;
  const auto say = [&](const std::string& text) {
    if (!options.quiet) fmt::print(stderr, "{}\n", text);
  };
  const bool whole =
      recordings::make_suite(options.request, {say, [&] { return guard.interrupted(); }});
  return whole ? process::kDone : process::kInterrupted;
}

}  // namespace

void add_suite_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SuiteOptions>();
  recordings::SuiteRequest& request = options->request;
  request.seeds = "reporting";
  CLI::App* command =
      app.add_subcommand("suite", "Make the fixed set of recordings that tables stand on");
  command->add_option("-o,--output", request.folder, "Folder; a sub-folder each recording")
      ->required();
  command->add_flag("--overwrite", request.overwrite,
                    "Write also where scans lie that no simulation has left");
  std::vector<std::string> sets;
  for (const simulation::SuiteSet& set : simulation::kSuiteSets) sets.emplace_back(set.name);
  command->add_option("--seeds", request.seeds, "Set of seeds; no two sets share one")
      ->check(CLI::IsMember(sets))
      ->capture_default_str();
  command->add_option("-j,--jobs", request.jobs, "Recordings made at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "No progress");
  command->callback([options, &exit_code] { exit_code = make(*options); });
}

}  // namespace surefoot::app
