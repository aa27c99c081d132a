// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot report: one HTML file that shows a run, or several beside each other.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "experiments/comparison_folder.hpp"
#include "io/recording.hpp"
#include "process/exit_codes.hpp"
#include "runs/report_maker.hpp"
#include "runs/run_files.hpp"

namespace surefoot::app {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::vector<fs::path> folders;
  fs::path truth;
  fs::path output;
  std::string title;
  std::size_t map_points = 0;
};

/// Within the folder if there is one, otherwise where the program was called.
fs::path default_output(const std::vector<fs::path>& folders) {
  return folders.size() == 1 ? folders.front() / runs::kReportFile : fs::path(runs::kReportFile);
}

/// A folder that cannot be read is told and left out; the others go on.
int make_report(const ReportOptions& options) {
  runs::ReportMaker maker(options.truth);
  std::size_t added = 0;
  for (const fs::path& folder : options.folders) {
    try {
      if (experiments::is_comparison_folder(folder)) {
        experiments::add_comparison(folder, maker);
      } else {
        maker.add_run(folder);
      }
      ++added;
    } catch (const io::ReadError& error) {
      if (options.folders.size() == 1) throw;
      fmt::print(stderr, "surefoot: left out: {}\n", error.what());
    }
  }
  if (added == 0) throw io::ReadError("none of the folders holds a run");
  for (const std::string& problem : maker.problems()) {
    fmt::print(stderr, "surefoot: {}\n", problem);
  }
  const fs::path file = options.output.empty() ? default_output(options.folders) : options.output;
  runs::write_report(maker.take(options.title), file, options.map_points);
  fmt::print("{}\n", file.string());
  return added == options.folders.size() && maker.problems().empty() ? process::kDone
                                                                     : process::kSomeFailed;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "Show a run, or several, on one page (HTML, needs no network)");
  command
      ->add_option("folders", options->folders,
                   "what surefoot run has written; several are compared")
      ->required();
  command->add_option("--truth", options->truth,
                      "TUM file (default: gt.tum of each run's recording, where there is one)");
  command->add_option("-o,--output", options->output,
                      "the page (default: report.html in the folder, or here for several)");
  command->add_option("--title", options->title, "of the page (default: the recording)");
  command
      ->add_option("--map-points", options->map_points,
                   "of each map at most (default: 400000, and 1000000 of all maps together)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
  command->callback([options, &exit_code] { exit_code = make_report(*options); });
}

}  // namespace surefoot::app
