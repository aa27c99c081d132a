// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot run: a recording in, trajectory and map out.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "evaluation/statistics.hpp"
#include "io/counted.hpp"
#include "map_outcome.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "recorded_options.hpp"
#include "run_command.hpp"
#include "run_options.hpp"
#include "runs/odometry_run.hpp"
#include "surefoot/quantile.hpp"
#include "text/printable.hpp"
#ifdef SUREFOOT_HAS_PCAP
#include "live/live_log.hpp"
#endif

namespace surefoot::app {

namespace {

void print_outcome(const runs::RunOutcome& outcome, const runs::RunOptions& options) {
  if (outcome.interrupted && outcome.scans() + outcome.unreadable == 0) {
    fmt::print("interrupted before any pose was known: nothing is written\n");
    return;
  }
  if (outcome.interrupted) fmt::print("interrupted: what was done up to here is written\n");
  if (options.reference) {
    fmt::print("{} at once, {:.1f} m\n", io::counted(outcome.scans(), "scan"), outcome.length);
  } else {
    fmt::print("{}, {:.1f} m; per scan {:.1f} ms median, {:.1f} ms p99, {}\n",
               io::counted(outcome.scans(), "scan"), outcome.length,
               quantile(outcome.milliseconds, 0.5), quantile(outcome.milliseconds, 0.99),
               io::counted(static_cast<std::size_t>(options.threads), "thread"));
  }
  for (const auto& [status, count] : outcome.statuses) {
    if (status != Status::ok) fmt::print("  {:5} {}\n", count, to_string(status));
  }
  if (outcome.partial > 0) fmt::print("  {:5} partial, left out\n", outcome.partial);
  if (outcome.unreadable > 0) fmt::print("  {:5} unreadable\n", outcome.unreadable);
  print_frames(outcome);
  fmt::print("results: {}\n", text::printable(outcome.folder.string()));
}

#ifdef SUREFOOT_HAS_PCAP
/// The scans that a live run used, read as it read them unless that is said: stamps of packets as
/// they are, those of topics mended as they come.
void repeat_live_run(runs::RunOptions& options) {
  live::UsedScans scans = live::used_scans(options.like);
  options.only_stamps = std::move(scans.used);
  options.reset_before = std::move(scans.reset_before);
  const bool is_said =
      std::any_of(options.given.begin(), options.given.end(), [](const auto& option) {
        return option.first == "repair-stamps" || option.first == "repair-at-once";
      });
  if (is_said) return;
  if (io::is_bag_input(options.input, options.reader)) {
    options.reader.repair_at_once = true;
    options.given.emplace_back("repair-at-once", "true");
  } else {
    options.reader.repair_stamps = false;
    options.given.emplace_back("repair-stamps", "false");
  }
}
#endif

/// Takes from a run.yaml how its run read and wrote, and the recording if none is named; what the
/// command line says goes before.
void complete_options(CLI::App& command, runs::RunOptions& options) {
  if (!options.config_file.empty()) {
    (void)runs::config_of(options);  // it says best what is wrong with a file
    const std::string taken = restore_options(command, options.config_file, options.input);
    if (!taken.empty() && !options.quiet) {
      fmt::print(stderr, "note: from {}: {}\n", options.config_file.string(),
                 text::printable(taken));
    }
  }
  if (options.input.empty()) {
    throw io::ReadError("no input: expected a recording, or a run.yaml as --config that names one");
  }
  options.given = recorded_options(command);
  const bool named = std::any_of(options.given.begin(), options.given.end(),
                                 [](const auto& option) { return option.first == "loop-closure"; });
  if (options.loop_closure && !named) options.given.emplace_back("loop-closure", "true");
}

}  // namespace

int run_recording(CLI::App& command, runs::RunOptions& options) {
  complete_options(command, options);
  take_piped_recording(options.input, options.quiet);
  take_piped_text(options.truth);
#ifdef SUREFOOT_HAS_PCAP
  if (!options.like.empty()) repeat_live_run(options);
#endif
  const process::InterruptGuard interrupt;
  process::Progress progress("scans", options.quiet);
  const auto say = [&](const std::string& text) {
    progress.finish();
    if (!options.quiet) fmt::print(stderr, "{}\n", text);
  };
  const auto complain = [&](const std::string& text) {
    progress.finish();
    fmt::print(stderr, "{}\n", text);
  };
  runs::RunListener listener{say,
                             [&](std::size_t done, double share) { progress.update(done, share); },
                             [&] { return interrupt.interrupted(); }};
  listener.complain = complain;
  const runs::RunOutcome outcome = runs::run_odometry(options, listener);
  progress.finish();
  if (!options.quiet) print_outcome(outcome, options);
  if (outcome.poses == 0 && outcome.interrupted) return process::kInterrupted;
  if (outcome.poses == 0) {
    throw io::ReadError(fmt::format(
        "{}: none of {} could be used; scans.csv in {} says why for each", options.input.string(),
        io::counted(outcome.scans() + outcome.unreadable, "scan"), outcome.folder.string()));
  }
  const bool apart = say_if_apart(outcome);
  if (outcome.interrupted) return process::kInterrupted;
  if (options.quiet) {
    for (const std::string& loss : outcome.losses) complain(loss);
  }
  const bool damaged = outcome.unreadable > 0 || !outcome.losses.empty();
  return apart || damaged ? process::kSomeFailed : process::kDone;
}

void add_run_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<runs::RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Turn a recording into a trajectory and a map");
  command->add_option(
      "input", options->input,
      "folder of scans (PCD, PLY, KITTI .bin, LAS), a bag (.bag, .db3, .mcap, or its "
      "folder) or a capture of packets (.pcap, .pcapng); default: that of --config's "
      "run.yaml");
  add_run_options(*command, *options);
#ifdef SUREFOOT_HAS_PCAP
  command
      ->add_option("--like", options->like,
                   "a live run's live.log: use only the scans that it used, to repeat it")
      ->type_name(command_line::kFileType);
#endif
  command->callback(
      [command, options, &exit_code] { exit_code = run_recording(*command, *options); });
}

}  // namespace surefoot::app
