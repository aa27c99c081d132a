// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recorded_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "command_line/option_checks.hpp"
#include "io/recording.hpp"
#include "surefoot/config.hpp"

namespace surefoot::app {

namespace {

/// What is recorded as a parameter, names files, or changes nothing about the results.
constexpr std::array kNotRecorded = {
    "help",      "config",       "method",        "set",           "extrinsic",      "level",
    "output",    "overwrite",    "quiet",         "mcap",          "rosbag2",        "threads",
    "udp",       "address",      "queue",         "record",        "replay",         "speed",
    "silence",   "no-loops",     "ros2-topic",    "ros2-domain",   "ros2-interface", "ros2-peer",
    "ros2-qos",  "ros2-node",    "ros2-publish",  "ros2-commands", "ros1-topic",     "ros1-master",
    "ros1-node", "ros1-publish", "ros1-commands", "page"};

bool is_recorded(const CLI::Option& option) {
  if (option.get_lnames().empty()) return false;  // the recording itself
  return std::find(kNotRecorded.begin(), kNotRecorded.end(), option.get_lnames().front()) ==
         kNotRecorded.end();
}

}  // namespace

runs::OptionTexts recorded_options(const CLI::App& command) {
  runs::OptionTexts result;
  for (const CLI::Option* option : command.get_options()) {
    if (option->empty() || !is_recorded(*option)) continue;
    std::string value = option->results().back();
    if (option->get_type_name() == command_line::kFileType) {
      value = std::filesystem::absolute(value).string();
    }
    result.emplace_back(option->get_lnames().front(), value);
  }
  return result;
}

std::string restore_options(CLI::App& command, const std::filesystem::path& file,
                            std::filesystem::path& input) {
  const runs::RunDescription run = runs::read_run_yaml(file);
  std::string taken;
  if (input.empty()) {
    input = run.input;
    taken = run.input;
  }
  for (const auto& [name, value] : run.options) {
    CLI::Option* option = command.get_option_no_throw("--" + name);
    if (option == nullptr || !is_recorded(*option)) {
      throw ConfigError(
          fmt::format("{}: options: there is no option '{}' to restore", file.string(), name));
    }
    if (!option->empty()) continue;  // the command line goes before
    try {
      option->add_result(value);
      option->run_callback();
    } catch (const CLI::Error& error) {
      throw ConfigError(fmt::format("{}: options: {}", file.string(), error.what()));
    }
    taken += fmt::format("{}--{}={}", taken.empty() ? "" : " ", name, value);
  }
  return taken;
}

}  // namespace surefoot::app
