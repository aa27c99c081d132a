// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot report: one HTML file that shows a run, or several beside each other.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "experiments/folder_report.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"

namespace surefoot::app {

void add_report_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<experiments::ReportRequest>();
  CLI::App* command =
      app.add_subcommand("report", "Show a run, or several, on one page (HTML, needs no network)");
  command
      ->add_option("folders", options->folders,
                   "what surefoot run has written; several are compared")
      ->required();
  command->add_option(
      "--truth", options->truth,
      "a trajectory with stamps and rotations (default: gt.tum of each run's recording, "
      "where there is one)");
  command->add_option("-o,--output", options->output,
                      "the page (default: report.html in the folder, or here for several)");
  command->add_option("--title", options->title, "of the page (default: the recording)");
  command
      ->add_option("--map-points", options->map_points,
                   "of each map at most (default: 400000, and 1000000 of all maps together)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
  command->callback([options, &exit_code] {
    take_piped_text(options->truth);
    const experiments::ReportOutcome outcome = experiments::report_folders(
        *options, [](const std::string& text) { fmt::print(stderr, "surefoot: {}\n", text); });
    fmt::print("{}\n", outcome.file.string());
    exit_code = outcome.is_whole ? process::kDone : process::kSomeFailed;
  });
}

}  // namespace surefoot::app
