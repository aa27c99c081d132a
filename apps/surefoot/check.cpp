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
#include "commands.hpp"
#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "io/printable.hpp"
#include "option_checks.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "reader_options.hpp"

namespace surefoot::app {
namespace {

namespace fs = std::filesystem;
using checks::Figures;
using checks::Finding;
using checks::RecordingCheck;

struct CheckCommand {
  checks::CheckOptions check;
  fs::path html;
  bool json = false;
  bool quiet = false;
};

void print_row(const char* name, const std::string& value) {
  fmt::print("{:<12} {}\n", name, io::printable(value));
}

void print_figures(const RecordingCheck& check) {
  const Figures& figures = check.figures;
  print_row("recording", check.description);
  for (const std::string& layout : check.layouts) print_row("fields", layout);
  if (figures.scans == 0) return;
  print_row("scans",
            fmt::format("{} at {:.2f} Hz, {} s", figures.scans, figures.rate_hz(),
                        io::format_seconds(figures.last_stamp_ns - figures.first_stamp_ns)));
  print_row("intervals",
            fmt::format("{:.4f} to {:.4f} s, usually {:.4f} s", figures.interval_s.least,
                        figures.interval_s.greatest, figures.usual_interval_s));
  print_row("points",
            fmt::format("{:.0f} to {:.0f} a scan, usually {:.0f}; {:.1f} % NaN, {:.1f} % "
                        "zero",
                        figures.points.least, figures.points.greatest, figures.points.median,
                        100.0 * figures.not_finite_share, 100.0 * figures.zero_share));
  print_row("ranges",
            fmt::format("{:.2f} to {:.2f} m, {:.2f} m in the middle", figures.range_m.least,
                        figures.range_m.greatest, figures.range_m.median));
  print_row("directions", fmt::format("{:.0f} % of those around", 100.0 * figures.around.median));
  if (!figures.rings.empty()) {
    print_row("rings", fmt::format("{}, {} to {}", figures.rings.size(), figures.rings.front(),
                                   figures.rings.back()));
  }
}

void print(const RecordingCheck& check) {
  print_figures(check);
  for (const std::string& note : check.notes) print_row("found out", note);
  for (const std::string& sentence : check.time_sentences) print_row("times", sentence);
  for (const std::string& sentence : check.motion_sentences) print_row("motion", sentence);
  for (const Finding& finding : check.findings) {
    std::string text = finding.what;
    if (finding.scans > 0) text += fmt::format(": {} (first: {})", finding.scans, finding.first);
    if (!finding.detail.empty()) text += (finding.scans > 0 ? "; " : ": ") + finding.detail;
    print_row(finding.suffers ? "suffers" : "odd", text);
  }
  print_row("verdict", check.verdict());
}

int execute(const CheckCommand& command) {
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
  if (!command.html.empty()) {
    io::write_whole_file(command.html,
                         checks::to_html(check, command.check.input.filename().string()));
  }
  if (command.json) {
    fmt::print("{}\n", checks::to_json(check));
  } else {
    print(check);
  }
  if (interrupt.interrupted()) return process::kInterrupted;
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
      ->type_name(kFileType);
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
