// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "compare_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "evaluation_options.hpp"
#include "experiments/comparison_engine.hpp"
#include "process/exit_codes.hpp"
#include "surefoot/config.hpp"

namespace surefoot::app {

namespace {

void add_input_options(CLI::App& command, experiments::CompareOptions& options) {
  command.add_option("recordings", options.recordings,
                     "Folders or captures, as for 'surefoot run', with gt.tum in the folder");
  command.add_option("--truth", options.truths,
                     "True trajectories with stamps, one for each recording, instead of gt.tum");
  command.add_option("--suite", options.suites,
                     "All recordings in folders made by 'surefoot suite'; or sets of it, tuning, "
                     "reporting ...: made in the output folder first, if not there yet");
  command.add_option("--set", options.settings, "key=value for every method; may be repeated")
      ->allow_extra_args(false);
}

void add_work_options(CLI::App& command, experiments::CompareOptions& options) {
  command.add_option("-o,--output", options.output, "Folder of all results")->capture_default_str();
  command
      .add_option("--repeat", options.repeats,
                  "Runs of each kind: spread of times; trajectories must be the same")
      ->check(CLI::Range(1, 1000));
  command.add_option("-j,--jobs", options.jobs, "Runs at the same time; they share the machine")
      ->check(CLI::Range(1, 64));
  command.add_flag("--overwrite", options.overwrite,
                   "Write also where tables or figures lie that no comparison has left");
  command.add_flag("--retry-failed", options.retry_failed, "Do again what failed before");
  command
      .add_option_function<std::string>(
          "--part",
          [&options](const std::string& text) { options.part = experiments::parse_part(text); },
          "Do this share of the runs and make no tables, beside others that do theirs: 3/8; each "
          "once at a time. The same call without it makes the tables")
      ->type_name("NUMBER/OF");
  command.add_flag("--list-runs", options.list_runs,
                   "Do nothing, but say which run each part is if there are as many parts as runs: "
                   "a line of JSON each");
  command.add_flag("--figures,!--no-figures", options.figures,
                   "Draw the trajectories as SVG and PNG (default: yes)");
  command.add_flag("-q,--quiet", options.quiet, "No progress; the tables alone");
}

void add_run_options(CLI::App& command, experiments::CompareOptions& options) {
  command_line::OptionGroup group(command, "Runs");
  group.add("--threads", options.threads, "Threads of each run")->check(CLI::Range(1, 1024));
  group.add("--start", options.start, "Scans to pass over at first")
      ->check(command_line::whole_number(0));
  group.add("--count", options.count, "Scans to use at most")->check(command_line::whole_number(1));
  group.add("--stride", options.stride, "Use every n-th scan")
      ->check(command_line::whole_number(1));
  group
      .add("--pass", options.passed,
           "A further argument of 'surefoot run': --pass=--rate=10; may be repeated")
      ->allow_extra_args(false);
}

void add_verdict_options(CLI::App& command, experiments::CompareOptions& options) {
  command_line::OptionGroup group(command, "Evaluation");
  using experiments::Cover;
  group.add_choice<Cover>(
      "--cover", options.cover,
      "What a run has to cover: truth, recording (the truth from its first scan to its last), or "
      "auto: the truth but for a second at either end, unless --start or --count leave scans out",
      {experiments::kCoverNames.begin(), experiments::kCoverNames.end()});
  group
      .add("--full-coverage", options.rules.full_coverage,
           "Share of it that a run must have an estimate for to be ranked")
      ->check(command_line::number_within(0.0, 1.0))
      ->capture_default_str();
}

}  // namespace

void add_shared_options(CLI::App& command, experiments::CompareOptions& options) {
  add_input_options(command, options);
  add_work_options(command, options);
  add_run_options(command, options);
  add_pairing_options(command, options.evaluation.association);
  add_error_options(command, options.evaluation);
  add_verdict_options(command, options);
}

void add_compare_options(CLI::App& command, experiments::CompareOptions& options) {
  add_shared_options(command, options);
  command
      .add_option("--methods", options.methods,
                  fmt::format("Some of {}; with '+' and key=value to change parameters: "
                              "paper,paper+deskew.segments=8",
                              fmt::join(methods(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command_line::OptionGroup(command, "Runs")
      .add_flag("--no-map", options.no_map, "Do not write map.ply");
}

int run_comparison(const experiments::CompareOptions& options,
                   const std::vector<experiments::MethodVariant>& variants,
                   const std::function<void(const experiments::CompareResults& results)>& write) {
  if (options.list_runs) {
    fmt::print("{}", experiments::list_runs(options, variants));
    return process::kDone;
  }
  const auto results = experiments::compare_variants(options, variants);
  if (!results) return process::kInterrupted;
  if (!options.part) write(*results);
  return experiments::exit_code_of(*results);
}

}  // namespace surefoot::app
