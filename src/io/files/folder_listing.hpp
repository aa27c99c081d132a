// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/files/scan_files.hpp"

namespace surefoot::io {

/// The scans of a folder, in natural order of their names.
struct FolderListing {
  std::filesystem::path folder;  ///< where the files are: the folder given or one of KITTI's below
  ScanFileKind kind = ScanFileKind::pcd;
  std::vector<std::filesystem::path> files;
};

/// Looks into `path`, then where KITTI, MulRan and Newer College have their scans below. `format`
/// ("pcd", "ply", "bin", "las" or empty) chooses where there are several kinds. Throws ReadError
/// naming what was seen.
[[nodiscard]] FolderListing list_folder(const std::filesystem::path& path,
                                        const std::string& format);

/// A folder and, of those below it, where scans and their stamps may lie.
[[nodiscard]] std::vector<std::filesystem::path> folders_of_recording(
    const std::filesystem::path& folder);

/// Files in the folder itself.
struct FolderCounts {
  std::size_t scans = 0;
  std::size_t captures = 0;
};
/// Throws ReadError where it cannot be listed.
[[nodiscard]] FolderCounts count_folder(const std::filesystem::path& folder);

/// Whether scans lie in the folder itself. Throws ReadError where it cannot be listed.
[[nodiscard]] bool holds_scan_files(const std::filesystem::path& folder);
/// The capture in a folder that holds one and no scans. Throws ReadError.
[[nodiscard]] std::optional<std::filesystem::path> only_capture(
    const std::filesystem::path& folder);

}  // namespace surefoot::io
