// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace surefoot::process {

/// Keeps a folder for one process at a time while it lives, or for several that agree to share it.
/// The system lets go of it however the process ends, and no file is left behind. Where a file
/// system knows no locks there is none.
class FolderLock {
 public:
  /// Throws std::runtime_error naming the folder if another process holds it.
  explicit FolderLock(const std::filesystem::path& folder, bool shared = false);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_;  // its descriptor; -1: none
};

}  // namespace surefoot::process
