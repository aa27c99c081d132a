// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/recording.hpp"

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_recording.hpp"
#include "io/datasets.hpp"
#include "io/files/folder_listing.hpp"
#include "io/files/folder_recording.hpp"
#include "io/files/scan_files.hpp"
#include "io/packets/capture_recording.hpp"
#include "io/point_time_watch.hpp"
#include "io/robots.hpp"
#include "io/stamp_repair.hpp"

namespace surefoot::io {
namespace {

// A folder of a bag's parts, and of no scans: those come first where both are there.
bool is_bag(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return is_bag_file(path);
  return !holds_scan_files(path) && !bag_files(path).empty();
}

std::unique_ptr<Recording> open_any(const std::filesystem::path& path, const OpenOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw ReadError(path.string() + ": no such file or folder");
  }
  if (is_bag(path)) return open_bag_recording(path, options);
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  if (is_folder) {
    if (const auto capture = only_capture(path)) return open_any(*capture, options);
  }
  if (is_folder || scan_file_kind(path)) {
    return open_scan_files(path, options);
  }
  if (is_capture(path)) {
#ifdef SUREFOOT_HAS_PCAP
    return open_capture(path, options);
#else
    throw ReadError(path.string() +
                    ": packet captures cannot be read: built without libpcap (SUREFOOT_PCAP=OFF)");
#endif
  }
  throw ReadError(
      path.string() + ": extension '" + path.extension().string() +
      "'; expected a folder of scans, or a .pcd, .ply, .bin, .las, .pcap, .pcapng, .bag, "
      ".db3 or .mcap file");
}

}  // namespace

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const OpenOptions& given) {
  const OpenOptions options = with_robot(with_dataset(given));
  std::unique_ptr<Recording> recording = watch_point_times(open_any(path, options), options);
  return options.repair_stamps ? repair_stamps(std::move(recording), options)
                               : std::move(recording);
}

}  // namespace surefoot::io
