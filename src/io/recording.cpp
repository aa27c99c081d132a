// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/recording.hpp"

#include <array>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_recording.hpp"
#include "io/bags/byte_stream.hpp"
#include "io/counted.hpp"
#include "io/datasets.hpp"
#include "io/file_kind.hpp"
#include "io/file_reader.hpp"
#include "io/files/folder_listing.hpp"
#include "io/files/folder_recording.hpp"
#include "io/files/scan_files.hpp"
#include "io/idle_options.hpp"
#include "io/packets/capture_recording.hpp"
#include "io/point_time_watch.hpp"
#include "io/recording_filter.hpp"
#include "io/robots.hpp"
#include "io/stamp_repair.hpp"

namespace surefoot::io {
namespace {

// What of a folder is passed over, and what is put together.
std::vector<std::string> folder_notes(const std::filesystem::path& path, bool as_bag) {
  std::error_code ignored;
  std::vector<std::string> notes;
  if (!std::filesystem::is_directory(path, ignored)) return notes;
  const std::vector<std::filesystem::path> bags = bag_files(path);
  const FolderCounts counts = count_folder(path);
  const auto pass_over = [&](std::size_t count, const std::string& what) {
    if (count > 0) notes.push_back("not read: " + counted(count, what) + " in the same folder");
  };
  if (as_bag) {
    pass_over(counts.scans, "scan file");
  } else {
    pass_over(bags.size(), "bag");
  }
  if (as_bag || counts.scans > 0 || counts.captures > 1) pass_over(counts.captures, "capture");
  if (as_bag && bags.size() > 1 && !is_rosbag2_folder(bag_folder(path))) {
    notes.push_back(counted(bags.size(), "bag") + " are read as parts of one recording, " +
                    bags.front().filename().string() + " first");
  }
  return notes;
}

/// A recording with notes more.
class NotedRecording final : public RecordingFilter {
 public:
  NotedRecording(std::unique_ptr<Recording> recording, const std::vector<std::string>& notes)
      : RecordingFilter(std::move(recording)) {
    for (const std::string& text : notes) note(text);
  }
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = recording().next();
    merge_notes();
    return item;
  }
};

std::unique_ptr<Recording> with_notes(std::unique_ptr<Recording> recording,
                                      const std::filesystem::path& path,
                                      const OpenOptions& options) {
  const bool as_bag = is_bag_input(path, options);
  const bool packets = recording->capture_counts().packets > 0;
  std::vector<std::string> notes = folder_notes(path, as_bag);
  for (std::string& text : idle_options(options, {as_bag, packets})) {
    notes.push_back(std::move(text));
  }
  if (notes.empty()) return recording;
  return std::make_unique<NotedRecording>(std::move(recording), notes);
}

// A recording is looked at, then read from its beginning.
void require_seekable(const std::filesystem::path& path) {
  try {
    require_regular_file(path);
  } catch (const ReadError& error) {
    std::error_code ignored;
    const bool is_pipe = std::filesystem::is_fifo(path, ignored);
    throw ReadError(path.string() + ": " + error.what() +
                    (is_pipe
                         ? ": it is read more than once, which a pipe cannot be; /dev/stdin < PIPE "
                           "is read by way of a temporary file"
                         : ""));
  }
}

// A clone of a repository has these where its large files would be.
void refuse_lfs_pointer(const std::filesystem::path& path) {
  std::array<std::byte, kTellingBytes> begin{};
  std::size_t size = 0;
  try {
    size = FileStream(path).read(begin);
  } catch (const ReadError&) {
    return;  // whoever reads it says so
  }
  if (is_lfs_pointer(std::span(begin).first(size))) {
    throw ReadError(path.string() + ": " + kLfsPointer);
  }
}

std::unique_ptr<Recording> open_any(const std::filesystem::path& path, const OpenOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw ReadError(path.string() + ": no such file or folder");
  }
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  if (!is_folder && !scan_kind(kind_of(path))) require_seekable(path);
  if (std::filesystem::is_regular_file(path, ignored)) refuse_lfs_pointer(path);
  if (is_bag_input(path, options)) return open_bag_recording(path, options);
  if (is_folder) {
    if (const auto capture = only_capture(path)) return open_any(*capture, options);
    const std::string why = holds_scan_files(path) ? "" : why_no_bag_files(path);
    if (!why.empty()) throw ReadError(path.string() + ": " + why);
  }
  const std::optional<FileKind> kind = kind_of(path);
  if (is_folder || scan_kind(kind)) return open_scan_files(path, options);
  if (kind == FileKind::capture) {
#ifdef SUREFOOT_HAS_PCAP
    return open_capture(path, options);
#else
    throw ReadError(path.string() +
                    ": packet captures cannot be read: built without libpcap (SUREFOOT_PCAP=OFF)");
#endif
  }
  if (path.extension() == ".yaml") {
    throw ReadError(path.string() + ": is no recording; a run.yaml is repeated by --config");
  }
  throw ReadError(path.string() + ": extension '" + path.extension().string() +
                  "'; expected a folder of scans, or a .pcd, .ply, .bin, .las, .pcap, .pcapng, "
                  ".bag, .db3 or .mcap file, or one that begins as these do");
}

}  // namespace

// A folder of a bag's parts. Scans come first where both are there, unless rosbag2 made the folder.
bool is_bag_input(const std::filesystem::path& path, const OpenOptions& options) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return is_bag_file(path);
  if (bag_files(path).empty()) return false;
  return (is_rosbag2_folder(path) && options.format.empty()) || !holds_scan_files(path);
}

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                          const OpenOptions& given) {
  const OpenOptions options = with_robot(with_dataset(given));
  std::unique_ptr<Recording> recording =
      watch_point_times(with_notes(open_any(path, options), path, given), options);
  return options.repair_stamps ? repair_stamps(std::move(recording), options)
                               : std::move(recording);
}

}  // namespace surefoot::io
