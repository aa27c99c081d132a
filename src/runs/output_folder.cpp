// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/output_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/bags/bag_files.hpp"
#include "io/files/scan_files.hpp"
#include "runs/run_files.hpp"
#include "runs/scans_csv.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;

namespace {

bool first_line_begins(const fs::path& file, const std::string& begin) {
  std::ifstream stream(file);
  std::string line;
  return std::getline(stream, line) && line.starts_with(begin);
}

/// A run's results would become scans of its own recording, or lie among them. What a live run
/// hears has a name, but no place.
void refuse_recording(const fs::path& folder, const fs::path& input) {
  std::error_code ignored;
  if (!fs::exists(input, ignored)) return;
  const fs::path recording = fs::is_directory(input, ignored)
                                 ? input
                                 : fs::absolute(input, ignored).lexically_normal().parent_path();
  if (fs::equivalent(folder, recording, ignored)) {
    throw std::runtime_error(
        folder.string() + ": is where the recording lies; choose another folder for the results");
  }
}

/// What a run has numbered, by its name; somebody's trajectory_map_of_campus.png is none.
bool is_numbered_run_file(const fs::directory_entry& entry) {
  if (!entry.is_regular_file() || entry.path().extension() != ".tum") return false;
  const std::string stem = entry.path().stem().string();
  for (const std::string_view files : {kSegmentFiles, kMapFrameFiles}) {
    if (!stem.starts_with(files)) continue;
    const std::string_view number = std::string_view(stem).substr(files.size());
    return !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
  }
  return false;
}

/// A file that the run would overwrite, or take for a result, but that no run has left.
std::string foreign_file(const fs::path& folder) {
  for (const char* name : kRunFiles) {
    if (fs::exists(folder / name)) return name;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool is_recording = io::scan_file_kind(entry.path()) || io::is_capture(entry.path()) ||
                              io::has_bag_name(entry.path());
    if ((entry.is_regular_file() && is_recording) || is_numbered_run_file(entry)) {
      return entry.path().filename().string();
    }
  }
  return {};
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_directory(folder)) return;
  throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder.string(),
                                       error ? error.message() : "it is a file"));
}

/// results/latest is ours if it points to a folder beside itself; whatever else has that name
/// stays.
void link_latest(const fs::path& folder) {
  const fs::path latest = folder.parent_path() / "latest";
  std::error_code error;  // some file systems have no links; the results do not need one
  if (fs::exists(fs::symlink_status(latest, error))) {
    const fs::path target = fs::read_symlink(latest, error);
    if (error || target.has_parent_path()) return;
    fs::remove(latest, error);
  }
  fs::create_directory_symlink(folder.filename(), latest, error);
}

fs::path new_folder(const fs::path& input) {
  const fs::path whole = fs::absolute(input).lexically_normal();
  const fs::path name = whole.has_filename() ? whole.stem() : whole.parent_path().filename();
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const std::string stem = fmt::format("{}-{:%Y%m%d-%H%M%S}", name.string(), fmt::localtime(now));
  fs::path folder = fs::path("results") / stem;
  make_folder(folder.parent_path());
  for (int i = 2; !fs::create_directory(folder); ++i) {
    folder = fs::path("results") / fmt::format("{}-{}", stem, i);
  }
  link_latest(folder);
  return folder;
}

fs::path whole_path(const fs::path& path) {
  return path.empty() ? path : fs::weakly_canonical(path);
}

fs::path ready_folder(const fs::path& asked, const fs::path& input) {
  if (asked.empty()) return new_folder(input);
  refuse_recording(asked, input);
  make_folder(asked);
  return asked;
}

/// Whether there were any of an earlier run's.
bool remove_run_files(const fs::path& folder, const std::vector<fs::path>& but) {
  bool removed = false;
  std::vector<fs::path> numbered;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_numbered_run_file(entry)) numbered.push_back(entry);
  }
  for (const fs::path& file : numbered) removed |= fs::remove(file);
  for (const char* name : kRunFiles) {
    const bool stays = std::any_of(but.begin(), but.end(), [&](const fs::path& kept) {
      std::error_code ignored;
      return fs::equivalent(folder / name, kept, ignored);
    });
    if (stays) continue;
    removed |= fs::remove(folder / name);
  }
  return removed;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& asked, const fs::path& input, bool overwrite,
                           const fs::path& continued, const fs::path& localized)
    : continued_(whole_path(continued)),
      localized_(whole_path(localized)),
      path_(ready_folder(asked, input)),
      lock_(path_) {
  if (!overwrite) refuse_losses();
}

void OutputFolder::clear() { replaced_ = remove_run_files(path_, {continued_, localized_}); }

void OutputFolder::refuse_losses() const {
  std::error_code ignored;
  if (!continued_.empty() && fs::equivalent(path_, continued_.parent_path(), ignored)) {
    throw std::runtime_error(
        fmt::format("{}: holds the map that is to be continued; choose another folder, or "
                    "--overwrite that map by the joint one",
                    path_.string()));
  }
  if (!is_run_folder(path_)) {
    if (const std::string foreign = foreign_file(path_); !foreign.empty()) {
      throw std::runtime_error(
          fmt::format("{}: holds {}, which no run has left there; choose another folder, or "
                      "--overwrite what has the names of a run's files",
                      path_.string(), foreign));
    }
  }
  for (const char* map : {kSavedMapFile, kApartMapFile}) {
    if (!fs::exists(path_ / map, ignored)) continue;
    throw std::runtime_error(
        fmt::format("{}: holds {}, a map to come back to; choose another folder, or --overwrite "
                    "it with the rest of that run",
                    path_.string(), map));
  }
}

bool is_run_folder(const fs::path& folder) {
  return first_line_begins(folder / kScansFile, scans_csv_beginning()) ||
         first_line_begins(folder / kDescriptionFile, "surefoot:");
}

}  // namespace surefoot::runs
