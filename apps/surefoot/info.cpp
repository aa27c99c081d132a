// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot info: what a recording holds and what is odd about it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "checks/check_json.hpp"
#include "checks/check_text.hpp"
#include "commands.hpp"
#include "io/recording.hpp"
#include "io/recording_summary.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"
#include "reader_options.hpp"
#include "runs/length_unit.hpp"

namespace surefoot::app {
namespace {

struct InfoOptions {
  std::filesystem::path input;
  io::OpenOptions reader;
  bool json = false;
};

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a recording holds and what is odd");
  command->add_option("input", options->input, "Folder of scans, one scan, a bag, or a capture")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  add_reader_options(*command, options->reader);
  command->callback([options, &exit_code] {
    options->reader.repair_stamps = false;  // what is odd is told, not mended
    take_piped_recording(options->input, options->json);
    const auto recording = io::open_recording(options->input, options->reader);
    io::RecordingSummary summary = io::summarise(*recording);
    if (const auto odd = runs::odd_range(summary.range_m.median)) {
      summary.oddities.push_back({*odd, summary.scans, ""});
    }
    fmt::print("{}", options->json ? checks::to_json(summary) + "\n" : checks::to_text(summary));
    exit_code = summary.unreadable > 0 ? process::kSomeFailed : process::kDone;
  });
}

}  // namespace surefoot::app
