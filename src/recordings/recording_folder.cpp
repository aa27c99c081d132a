// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/recording_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "io/files/scan_files.hpp"

namespace surefoot::recordings {

namespace fs = std::filesystem;

namespace {

/// Besides scans and folders.
constexpr std::array<std::string_view, 5> kFiles = {kTruthFile, kStampsFile, kCaptureFile,
                                                    kMcapFile, kSceneFile};

fs::path make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
  return folder;
}

/// Whether scan_file() gives this name.
bool is_scan_name(const std::string& name) {
  const std::size_t digits = name.size() < 4 ? 0 : name.size() - 4;
  return digits >= 6 && name.ends_with(".pcd") &&
         std::all_of(name.begin(), name.end() - 4, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_simulated(const fs::path& folder) {
  std::ifstream stream(folder / kSceneFile);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  return json.is_object() && json.contains("surefoot") && json.contains("scene");
}

std::string foreign_file(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours = std::find(kFiles.begin(), kFiles.end(), name) != kFiles.end();
    if (is_ours || name == kBagFolder || io::scan_file_kind(entry.path())) return name;
  }
  return {};
}

void remove_scans(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> scans;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_scan_name(entry.path().filename().string())) scans.push_back(entry.path());
  }
  for (const fs::path& scan : scans) fs::remove(scan);
}

/// The scene last: without it what is left would be nobody's.
void remove_recording(const fs::path& folder) {
  remove_scans(folder);
  remove_scans(folder / kTrueFolder);
  fs::remove_all(folder / kBagFolder);
  for (const std::string_view name : kFiles) fs::remove(folder / name);
}

}  // namespace

std::string scan_file(std::size_t index) { return fmt::format("{:06}.pcd", index); }

RecordingFolder::RecordingFolder(const fs::path& folder, bool overwrite)
    : path_(make_folder(folder)), lock_(path_) {
  if (!overwrite && !is_simulated(path_)) {
    if (const std::string foreign = foreign_file(path_); !foreign.empty()) {
      throw std::runtime_error(fmt::format(
          "{}: holds {}, which no simulation has left there; choose another folder, or --overwrite "
          "what has the names of a simulation's files",
          path_.string(), foreign));
    }
  }
  remove_recording(path_);
}

}  // namespace surefoot::recordings
