// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recorded_options.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "command_line/option_texts.hpp"
#include "surefoot/config.hpp"
#include "text/printable.hpp"

namespace surefoot::app {

namespace {

/// What is recorded as a parameter, names files, or changes nothing about the results.
constexpr std::array kNotRecorded = {
    "help",      "config",       "method",        "set",           "extrinsic",      "level",
    "output",    "overwrite",    "quiet",         "mcap",          "rosbag2",        "threads",
    "udp",       "address",      "queue",         "record",        "replay",         "follow",
    "speed",     "silence",      "ros2-topic",    "ros2-domain",   "ros2-interface", "ros2-peer",
    "ros2-qos",  "ros2-node",    "ros2-publish",  "ros2-commands", "ros1-topic",     "ros1-master",
    "ros1-node", "ros1-publish", "ros1-commands", "page"};

/// What `surefoot run` would make of them are other poses, or no map.
void refuse_run_of_another(const std::string& command, const std::filesystem::path& file) {
  if (command != "map" && command != "reference") return;
  throw ConfigError(fmt::format("{}: is of surefoot {}, which repeats it: surefoot {} --config {}",
                                file.string(), command, command, text::shell_word(file.string())));
}

}  // namespace

runs::OptionTexts recorded_options(const CLI::App& command) {
  return command_line::given_options(command, kNotRecorded);
}

std::string restore_options(CLI::App& command, const std::filesystem::path& file,
                            std::filesystem::path& input) {
  const runs::RunDescription run = runs::read_run_yaml(file);
  if (command.get_name() == "run") refuse_run_of_another(run.command, file);
  std::string taken;
  if (input.empty()) {
    input = run.input;
    taken = run.input;
  }
  try {
    const std::string given = command_line::give_options(command, run.options, kNotRecorded);
    return taken + (taken.empty() || given.empty() ? "" : " ") + given;
  } catch (const std::invalid_argument& error) {
    throw ConfigError(fmt::format("{}: options: {}", file.string(), error.what()));
  }
}

}  // namespace surefoot::app
