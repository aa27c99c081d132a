// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot info: what a recording holds and what is odd about it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "checks/check_json.hpp"
#include "checks/check_text.hpp"
#include "commands.hpp"
#include "io/bags/bag_files.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/recording.hpp"
#include "io/recording_summary.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"
#include "reader_options.hpp"
#include "runs/input_checks.hpp"
#include "runs/length_unit.hpp"

namespace surefoot::app {
namespace {

struct InfoOptions {
  std::filesystem::path input;
  io::OpenOptions reader;
  bool json = false;
};

/// Of a bag, by its first seconds; empty of any other recording.
std::vector<io::TopicSurvey> topics_of(const InfoOptions& options) {
  if (!io::is_bag_input(options.input, options.reader)) return {};
  const auto bag = io::open_bag(options.input);
  return io::survey_topics(*bag, options.reader).topics;
}

/// Whether nothing says which topic's scans are asked for.
bool has_a_choice(const InfoOptions& options, const std::vector<io::TopicSurvey>& topics) {
  const io::OpenOptions& reader = options.reader;
  const auto usable = std::count_if(topics.begin(), topics.end(),
                                    [](const io::TopicSurvey& topic) { return topic.usable; });
  return usable > 1 && reader.topic.empty() && reader.dataset.empty() && reader.robot.empty();
}

int tell(InfoOptions& options) {
  options.reader.repair_stamps = false;  // what is odd is told, not mended
  runs::refuse_run_folder(options.input);
  take_piped_recording(options.input, options.json);
  const std::vector<io::TopicSurvey> topics = topics_of(options);
  if (has_a_choice(options, topics)) {
    fmt::print("{}", options.json ? checks::to_json(topics) + "\n" : checks::to_text(topics));
    return process::kDone;
  }
  const auto recording = io::open_recording(options.input, options.reader);
  io::RecordingSummary summary = io::summarise(*recording);
  if (const auto odd = runs::odd_range(summary.range_m.median)) {
    summary.oddities.push_back({*odd, summary.scans, ""});
  }
  fmt::print("{}", options.json ? checks::to_json(summary, topics) + "\n"
                                : checks::to_text(summary, topics));
  return summary.unreadable > 0 ? process::kSomeFailed : process::kDone;
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a recording holds and what is odd");
  command->add_option("input", options->input, "Folder of scans, one scan, a bag, or a capture")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  add_reader_options(*command, options->reader);
  command->callback([options, &exit_code] { exit_code = tell(*options); });
}

}  // namespace surefoot::app
