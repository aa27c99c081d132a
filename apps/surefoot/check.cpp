// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot check: whether a recording is fit for a run, and whether its motion agrees with its
// times.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "checks/check_json.hpp"
#include "checks/check_page.hpp"
#include "checks/check_text.hpp"
#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/file_writer.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "reader_options.hpp"
#include "runs/input_checks.hpp"

namespace surefoot::app {
namespace {

namespace fs = std::filesystem;
using checks::RecordingCheck;

struct CheckCommand {
  checks::CheckOptions check;
  fs::path html;
  bool json = false;
  bool quiet = false;
};

int execute(const CheckCommand& command) {
  checks::require_page_or_nothing(command.html);
  io::require_ending(command.html, {".html", ".htm"});
  runs::refuse_run_folder(command.check.input);
  take_piped_recording(command.check.input, command.quiet || command.json);
  take_piped_text(command.check.truth);
  const process::InterruptGuard interrupt;
  const bool quiet = command.quiet || command.json;
  process::Progress progress("scans", quiet);
  const auto say = [&](const std::string& text) {
    progress.finish();
    if (!quiet) fmt::print(stderr, "{}\n", text);
  };
  const RecordingCheck check = checks::check_recording(
      command.check, {[&](std::size_t scans, double share) { progress.update(scans, share); }, say,
                      [&] { return interrupt.interrupted(); }});
  progress.finish();
  if (interrupt.interrupted()) {
    fmt::print(stderr, "interrupted: what was not looked at may be anything, so no verdict\n");
    return process::kInterrupted;
  }
  if (!command.html.empty()) {
    io::write_whole_file(command.html,
                         checks::to_html(check, command.check.input.filename().string()));
  }
  fmt::print("{}", command.json ? checks::to_json(check) + "\n" : checks::to_text(check));
  return check.suffers() ? process::kSomeFailed : process::kDone;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<CheckCommand>();
  CLI::App* command = app.add_subcommand(
      "check", "Say whether a recording is fit for a run (exit code 1: it would suffer)");
  command->add_option("input", options->check.input, "any recording that 'surefoot run' takes")
      ->required();
  command->add_flag("--json", options->json, "print JSON");
  command->add_option("--html", options->html, "also write a page with pictures to this file");
  command->add_flag("--motion,!--no-motion", options->check.motion,
                    "try the point times on the stretch that turns most (default: yes)");
  command
      ->add_option("--motion-scans", options->check.stretch_scans, "length of that stretch [scans]")
      ->check(CLI::Range(10, 1000))
      ->capture_default_str();
  command
      ->add_option("--truth", options->check.truth,
                   "TUM file, or a bag with poses, that tells what the stamps name (a gyroscope in "
                   "the bag, else gt.tum in the folder)")
      ->type_name(command_line::kFileType);
  command->add_option("--truth-topic", options->check.truth_topic, "topic of that bag's poses");
  command
      ->add_option("--threads", options->check.threads, "threads at most; the result is the same")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_flag("-q,--quiet", options->quiet, "no progress");
  add_reader_options(*command, options->check.reader);
  command->callback([options, &exit_code] { exit_code = execute(*options); });
}

}  // namespace surefoot::app
