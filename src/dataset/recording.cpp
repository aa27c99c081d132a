// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/recording.hpp"

#include "dataset/capture_recording.hpp"
#include "dataset/folder_recording.hpp"
#include "dataset/scan_files.hpp"

namespace surefoot::dataset {
namespace {

bool is_capture(const std::filesystem::path& path) {
  return path.extension() == ".pcap" || path.extension() == ".pcapng";
}

}  // namespace

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const OpenOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw ReadError(path.string() + ": no such file or folder");
  }
  if (std::filesystem::is_directory(path, ignored) || scan_file_kind(path)) {
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
  throw ReadError(path.string() + ": extension '" + path.extension().string() +
                  "'; expected a folder of scans, or a .pcd, .ply, .bin, .pcap or .pcapng file");
}

}  // namespace surefoot::dataset
