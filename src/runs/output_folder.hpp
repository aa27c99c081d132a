// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a run writes to, and what must not be lost there.
#pragma once

#include <filesystem>

#include "process/folder_lock.hpp"

namespace surefoot::runs {

/// A folder that one run has for itself.
class OutputFolder {
 public:
  /// Makes the folder that was asked for, or a new one under results/ with results/latest pointing
  /// to it. Throws std::runtime_error for a folder that another run is writing to, that the
  /// recording itself lies in, or, unless `overwrite`, that holds files of a run's names, or
  /// scans, which no run has left, a map to come back to, or the map file `continued` (empty:
  /// none). That one stays, and so does the map file `localized` that the run is found in.
  OutputFolder(const std::filesystem::path& asked, const std::filesystem::path& input,
               bool overwrite, const std::filesystem::path& continued = {},
               const std::filesystem::path& localized = {});

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Removes an earlier run's files, so that files of two runs never lie beside each other.
  void clear();
  /// Whether there were any.
  [[nodiscard]] bool replaced() const { return replaced_; }

 private:
  void refuse_losses() const;

  std::filesystem::path continued_;  // whole, before results/latest points elsewhere
  std::filesystem::path localized_;  // likewise
  std::filesystem::path path_;
  process::FolderLock lock_;
  bool replaced_ = false;
};

/// Whether a run has left the folder, to its end or not.
[[nodiscard]] bool is_run_folder(const std::filesystem::path& folder);

}  // namespace surefoot::runs
