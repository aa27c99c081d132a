// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/folder_listing.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "io/counted.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

constexpr std::array<ScanFileKind, 4> kKinds = {ScanFileKind::pcd, ScanFileKind::ply,
                                                ScanFileKind::kitti_bin, ScanFileKind::las};

// Where KITTI's, MulRan's and Newer College's recordings have their scans.
constexpr std::array<const char*, 6> kBelow = {
    "velodyne_points/data",   "velodyne",   "Ouster", "sensor_data/Ouster",
    "raw_format/ouster_scan", "ouster_scan"};

// The files of one folder by kind, and how many are none of them.
struct Sorted {
  std::array<std::vector<std::filesystem::path>, kKinds.size()> by_kind;
  std::size_t others = 0;
  std::vector<std::filesystem::path> captures;
  // Named as scans are, but no files: pipes, folders, links that lead nowhere.
  std::array<std::vector<std::filesystem::path>, kKinds.size()> no_files;

  [[nodiscard]] std::string counts() const {
    std::string text;
    for (std::size_t k = 0; k < kKinds.size(); ++k) {
      text += std::to_string(by_kind[k].size()) + " " + name_of(kKinds[k]) + ", ";
    }
    return text + counted(captures.size(), "capture") + " and " + counted(others, "other file");
  }
  [[nodiscard]] std::size_t kinds() const {
    return static_cast<std::size_t>(std::count_if(
        by_kind.begin(), by_kind.end(), [](const auto& files) { return !files.empty(); }));
  }
};

Sorted sort_folder(const std::filesystem::path& folder) {
  Sorted sorted;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    const std::filesystem::path& file = it->path();
    if (file.filename().string().starts_with(".")) continue;
    const std::optional<ScanFileKind> kind = scan_file_kind(file);
    if (!it->is_regular_file(ignored)) {
      if (kind) sorted.no_files[static_cast<std::size_t>(*kind)].push_back(file);
    } else if (kind) {
      sorted.by_kind[static_cast<std::size_t>(*kind)].push_back(file);
    } else if (is_capture(file)) {
      sorted.captures.push_back(file);
    } else {
      ++sorted.others;
    }
  }
  if (error) {
    throw ReadError(folder.string() + ": cannot list it: " + error.message());
  }
  return sorted;
}

// What surefoot run has left also holds a map.ply.
bool holds_a_run(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / "run.yaml", ignored);
}

// Folders below, a few levels deep, that hold scans or captures: "a/b, a/c". Not all are looked at.
std::string folders_with_scans(const std::filesystem::path& folder) {
  constexpr int kDeepest = 4;
  constexpr std::size_t kMostEntries = 10'000, kMostNamed = 5;
  std::set<std::string> found;
  std::error_code error;
  std::size_t entries = 0;
  for (std::filesystem::recursive_directory_iterator it(folder, error), end;
       !error && it != end && ++entries < kMostEntries && found.size() < kMostNamed;
       it.increment(error)) {
    std::error_code ignored;
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    const std::filesystem::path& file = it->path();
    if (it.depth() == 0 || !it->is_regular_file(ignored)) continue;
    if ((scan_file_kind(file) || is_capture(file)) && !holds_a_run(file.parent_path())) {
      found.insert(text::printable(file.parent_path().lexically_relative(folder).string()));
    }
  }
  std::string names;
  for (const std::string& name : found) names += (names.empty() ? "" : ", ") + name;
  return names;
}

ScanFileKind kind_of_format(const std::string& format) {
  const std::optional<ScanFileKind> kind = scan_file_kind("scan." + format);
  if (!kind) {
    throw ReadError("format '" + format + "'; expected pcd, ply, bin or las");
  }
  return *kind;
}

}  // namespace

std::vector<std::filesystem::path> folders_of_recording(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> folders = {folder};
  for (const std::filesystem::path below : kBelow) {
    for (const std::filesystem::path& one : {below.parent_path(), below}) {
      std::error_code ignored;
      if (!one.empty() && std::filesystem::is_directory(folder / one, ignored)) {
        folders.push_back(folder / one);
      }
    }
  }
  return folders;
}

FolderCounts count_folder(const std::filesystem::path& folder) {
  const Sorted sorted = sort_folder(folder);
  FolderCounts counts{0, sorted.captures.size()};
  for (const auto& files : sorted.by_kind) counts.scans += files.size();
  return counts;
}

bool holds_scan_files(const std::filesystem::path& folder) {
  return sort_folder(folder).kinds() > 0;
}

std::optional<std::filesystem::path> only_capture(const std::filesystem::path& folder) {
  const Sorted sorted = sort_folder(folder);
  const bool scans_below = std::any_of(kBelow.begin(), kBelow.end(), [&](const char* below) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder / below, ignored);
  });
  if (sorted.kinds() > 0 || scans_below || sorted.captures.size() != 1) return std::nullopt;
  return sorted.captures.front();
}

FolderListing list_folder(const std::filesystem::path& path, const std::string& format) {
  FolderListing listing;
  listing.folder = path;
  Sorted sorted = sort_folder(path);
  const std::string counts = sorted.counts();
  for (const char* below : kBelow) {
    std::error_code ignored;
    if (sorted.kinds() == 0 && std::filesystem::is_directory(path / below, ignored)) {
      listing.folder = path / below;
      sorted = sort_folder(listing.folder);
    }
  }
  if (sorted.kinds() > 1 && format.empty()) {
    throw ReadError(
        listing.folder.string() + ": " + sorted.counts() +
        "; expected scans of one kind, or --format with the one to read: pcd, ply, bin or las");
  }
  for (const ScanFileKind kind : kKinds) {
    std::vector<std::filesystem::path>& files = sorted.by_kind[static_cast<std::size_t>(kind)];
    if (!files.empty() && (format.empty() || kind == kind_of_format(format))) {
      listing.kind = kind;
      listing.files = std::move(files);
      // Each is a scan that cannot be read, which keeps the others with their stamps.
      const auto& no_files = sorted.no_files[static_cast<std::size_t>(kind)];
      listing.files.insert(listing.files.end(), no_files.begin(), no_files.end());
    }
  }
  if (listing.files.empty()) {
    const std::string below = folders_with_scans(path);
    throw ReadError(
        path.string() + ": " + counts +
        (below.empty() ? "" : "; there are some in " + below + ": name the folder") +
        (format.empty() ? "" : ", but format " + format + " is asked for") +
        "; expected a folder of PCD, PLY, KITTI .bin or LAS files or of a bag, or one capture");
  }
  std::sort(listing.files.begin(), listing.files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  return listing;
}

}  // namespace surefoot::io
