// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/output_checks.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "io/file_writer.hpp"

namespace surefoot::runs {

namespace {

/// Of what is to be written there; the run's own is made.
void require_folder_of(const std::filesystem::path& file, const std::filesystem::path& of_run) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::absolute(file).parent_path();
  if (fs::is_directory(folder)) return;
  if (!of_run.empty() && folder == (fs::absolute(of_run) / "").lexically_normal().parent_path()) {
    return;
  }
  throw std::runtime_error(
      fmt::format("{}: cannot be written: there is no folder {}", file.string(), folder.string()));
}

/// What is there already stays, unless it may go; the recording itself always does.
void check_bags(const RunOptions& options) {
  io::require_ending(options.mcap, {".mcap"});
  if (!options.mcap.empty()) require_folder_of(options.mcap, options.output);
  for (const std::filesystem::path& path : {options.mcap, options.rosbag2}) {
    std::error_code ignored;
    if (path.empty() || !std::filesystem::exists(path, ignored)) continue;
    if (std::filesystem::equivalent(path, options.input, ignored)) {
      throw std::runtime_error(path.string() + ": is the recording itself");
    }
    if (!options.overwrite && !std::filesystem::is_empty(path, ignored)) {
      throw std::runtime_error(path.string() +
                               ": is there already; choose another name, or --overwrite");
    }
  }
}

/// It is one of the files that go where a run's folder is written anew.
void check_log(const RunOptions& options) {
  std::error_code ignored;
  if (options.like.empty() || options.output.empty()) return;
  const std::filesystem::path folder = std::filesystem::absolute(options.like).parent_path();
  if (!std::filesystem::equivalent(folder, options.output, ignored)) return;
  throw std::runtime_error(options.output.string() + ": is where " +
                           options.like.filename().string() +
                           " lies, which is to be followed; choose another folder");
}

}  // namespace

void check_outputs(const RunOptions& options) {
  check_bags(options);
  check_log(options);
}

}  // namespace surefoot::runs
