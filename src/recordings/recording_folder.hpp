// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a simulated recording is written to, and what must not be lost there.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "process/folder_lock.hpp"

namespace surefoot::recordings {

inline constexpr const char* kTruthFile = "gt.tum";
inline constexpr const char* kStampsFile = "times.txt";
inline constexpr const char* kCaptureFile = "recording.pcap";
inline constexpr const char* kMcapFile = "recording.mcap";
inline constexpr const char* kBagFolder = "rosbag2";
inline constexpr const char* kSceneFile = "scene.json";  ///< by it a recording is known for ours
inline constexpr const char* kTrueFolder = "true";

/// 000012.pcd.
[[nodiscard]] std::string scan_file(std::size_t index);

/// A folder that one simulation has for itself.
class RecordingFolder {
 public:
  /// Makes it. An earlier simulation's files are removed: two recordings never lie mixed. Throws
  /// std::runtime_error for a folder that another process is writing to, or, unless `overwrite`,
  /// that holds scans or a truth that no simulation has left.
  RecordingFolder(const std::filesystem::path& folder, bool overwrite);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  process::FolderLock lock_;
};

}  // namespace surefoot::recordings
