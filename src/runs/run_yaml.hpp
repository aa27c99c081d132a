// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// run.yaml: what a run was, and what repeats it. One table of entries writes it and reads it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "surefoot/config.hpp"

namespace surefoot::runs {

/// Options as the command line knows them, by their long names without the dashes.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

struct RunDescription {
  std::string version;  ///< of the program
  std::string command;  ///< that made it: "run", "map", "reference", "live"; of old files empty
  std::string method;
  std::string input;    ///< the recording's absolute path
  std::string content;  ///< what it was found to hold
  std::vector<std::string> notes;
  OptionTexts options;  ///< how it was read and written, where that was not left to the program
  std::string scans;    ///< how many were used
  std::string unreadable;
  std::string untrusted;
  std::vector<std::string> segments;  ///< one line each, where there are several
  std::string interrupted = "false";
  std::string level;
  std::string pose_of;  ///< "lidar" or "base"
  std::string processor;
  std::string cores;
  std::string threads;
  std::string compiler;
  OptionTexts parameters;  ///< those that the method reads, by their names, as used
};

/// The parameters that the config's method reads, by name.
[[nodiscard]] OptionTexts parameter_texts(const Config& config);

[[nodiscard]] std::string run_yaml_text(const RunDescription& run);
/// Throws io::WriteError; there is the whole file or none.
void write_run_yaml(const std::filesystem::path& file, const RunDescription& run);
/// Entries that are missing are empty. Throws io::ReadError naming the file.
[[nodiscard]] RunDescription read_run_yaml(const std::filesystem::path& file);

}  // namespace surefoot::runs
