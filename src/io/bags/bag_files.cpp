// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/bag_files.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/ascii_values.hpp"
#include "io/bags/bag_metadata.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/bags/sqlite_bag_reader.hpp"
#include "io/file_kind.hpp"
#include "io/file_reader.hpp"
#include "io/files/folder_listing.hpp"
#include "io/files/scan_files.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadataFile = "metadata.yaml";

// What rosbag2 wrote beside its files when it closed the bag; nothing in it where it did not.
BagMetadata metadata_in(const fs::path& folder) {
  const fs::path file = folder / kMetadataFile;
  std::error_code error;
  constexpr std::uintmax_t kMostBytes = 64 << 20;
  const std::uintmax_t size = fs::file_size(file, error);
  if (error || size > kMostBytes) return {};
  try {
    std::vector<std::byte> bytes;
    read_whole_file(file, bytes);
    return parse_bag_metadata(text_of(bytes));
  } catch (const ReadError&) {
    return {};
  }
}

// Whole or compressed; nothing where neither is there.
std::optional<fs::path> part_named(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  for (const char* ending : {"", ".zstd", ".zst", ".gz", ".bz2", ".lz4"}) {
    fs::path file = folder / (name + ending);
    if (fs::is_regular_file(file, ignored)) return file;
  }
  return std::nullopt;
}

// Those that lie there by names of bags.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    const fs::path& file = it->path();
    const bool hidden = file.filename().string().starts_with(".");
    if (it->is_regular_file(ignored) && !hidden && has_bag_name(file)) files.push_back(file);
  }
  return files;
}

// The only folder in it with rosbag2's metadata; none where there are several.
std::optional<fs::path> only_rosbag2_in(const fs::path& folder) {
  std::optional<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!it->is_directory(ignored) || !is_rosbag2_folder(it->path())) continue;
    if (std::exchange(found, it->path())) return std::nullopt;
  }
  return found;
}

bool holds_scans(const fs::path& folder) {
  const std::vector<fs::path> folders = folders_of_recording(folder);
  return std::any_of(folders.begin(), folders.end(), [](const fs::path& one) {
    const FolderCounts counts = count_folder(one);
    return counts.scans > 0 || counts.captures > 0;
  });
}

// The files that the metadata name, in their order; none where one of them is not there.
std::vector<fs::path> named_files(const fs::path& folder, const BagMetadata& metadata) {
  std::vector<fs::path> files;
  for (const std::string& name : metadata.files) {
    const auto file = part_named(folder, name);
    if (!file || !has_bag_name(*file)) return {};
    files.push_back(*file);
  }
  return files;
}

// What the metadata name and is not there.
std::vector<std::string> missing_files(const fs::path& folder, const BagMetadata& metadata) {
  std::vector<std::string> missing;
  for (const std::string& name : metadata.files) {
    if (!part_named(folder, name)) missing.push_back(name);
  }
  return missing;
}

std::unique_ptr<MessageSource> open_part(const fs::path& file) {
  try {
    const std::optional<FileKind> kind = kind_of(file);
    if (kind == FileKind::sqlite_bag) return read_sqlite_bag(file);
    if (kind == FileKind::ros1_bag) return read_ros1_bag(open_stream(file));
    return read_mcap(open_stream(file));
  } catch (const ReadError& error) {
    throw ReadError(file.string() + ": " + error.what());
  }
}

/// The files of a bag one after the other. The last one stays open at its end.
class BagParts final : public MessageSource {
 public:
  BagParts(std::vector<fs::path> files, const std::vector<std::string>& missing,
           const BagMetadata& metadata)
      : files_(std::move(files)),
        part_(open_part(files_.front())),
        follow_in_time_(metadata.files.size() > 1),
        announced_messages_(metadata.messages) {
    for (const std::string& name : missing) {
      note("metadata.yaml names " + text::printable(name) + ", which is not there");
    }
  }

  std::optional<Message> next() override {
    do {
      part_->want(wanted());
      std::optional<Message> message = part_->next();
      take_notes();
      if (message) return message;
    } while (open_next());
    compare_counts();
    return std::nullopt;
  }

  bool rewind() override { return files_.size() == 1 && part_->rewind(); }
  bool is_in_order_of_time() const override { return follow_in_time_; }
  bool leave_file() override {
    announced_messages_.reset();  // not all are met any more
    return !follow_in_time_ && open_next();
  }
  double progress() const override {
    return (static_cast<double>(index_) + part_->progress()) / static_cast<double>(files_.size());
  }
  std::string format() const override {
    return part_->format() +
           (files_.size() > 1 ? " in " + std::to_string(files_.size()) + " files" : "");
  }

 private:
  void take_notes() {
    const PassedOver& here = part_->passed_over();
    set_passed_over(
        {passed_before_.attachments + here.attachments, passed_before_.metadata + here.metadata});
    const std::string where = files_.size() > 1 ? files_[index_].filename().string() + ": " : "";
    const std::vector<std::string>& losses = part_->losses();
    for (; noted_ < part_->notes().size(); ++noted_) {
      const std::string& text = part_->notes()[noted_];
      const bool lost = std::find(losses.begin(), losses.end(), text) != losses.end();
      lost ? note(where + text) : note_harmless(where + text);
    }
    for (; announced_ < part_->announced().size(); ++announced_) {
      announce(part_->announced()[announced_]);
    }
  }

  void compare_counts() {
    const std::uint64_t met = met_before_ + part_->met();
    if (!announced_messages_ || met == *announced_messages_) return;
    note("metadata.yaml says " + std::to_string(*announced_messages_) + " messages; " +
         std::to_string(met) + " were found");
  }

  // False where there is none after this one that can be read.
  bool open_next() {
    while (index_ + 1 < files_.size()) {
      ++index_;
      try {
        met_before_ += part_->met();
        passed_before_ = passed_over();
        part_ = open_part(files_[index_]);
        noted_ = announced_ = 0;
        return true;
      } catch (const ReadError& error) {
        note(std::string("passed over: ") + error.what());
      }
    }
    return false;
  }

  std::vector<fs::path> files_;
  std::unique_ptr<MessageSource> part_;
  std::size_t index_ = 0;
  std::size_t noted_ = 0;
  std::size_t announced_ = 0;
  bool follow_in_time_;                              ///< rosbag2's, each with all topics
  std::optional<std::uint64_t> announced_messages_;  ///< as its metadata say
  std::uint64_t met_before_ = 0;                     ///< in the parts before this one
  PassedOver passed_before_;                         ///< there
};

}  // namespace

bool has_bag_name(const fs::path& file) { return is_bag_kind(kind_by_name(file)); }
bool is_bag_file(const fs::path& file) { return is_bag_kind(kind_of(file)); }

bool is_rosbag2_folder(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / kMetadataFile, ignored);
}

fs::path bag_folder(const fs::path& folder) {
  if (is_rosbag2_folder(folder)) return folder;
  const std::optional<fs::path> below = only_rosbag2_in(folder);
  return below && files_in(folder).empty() && !holds_scans(folder) ? *below : folder;
}

std::vector<fs::path> bag_files(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  const fs::path folder = bag_folder(path);
  std::vector<fs::path> files = named_files(folder, metadata_in(folder));
  if (!files.empty()) return files;
  files = files_in(folder);
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  // A part that lies there compressed and plain is one part.
  std::erase_if(files, [&](const fs::path& file) {
    const fs::path plain = uncompressed_name(file);
    return plain != file && std::find(files.begin(), files.end(), plain) != files.end();
  });
  return files;
}

std::string why_no_bag_files(const fs::path& path) {
  const fs::path folder = bag_folder(path);
  const std::vector<std::string> missing = missing_files(folder, metadata_in(folder));
  if (missing.empty()) return {};
  const std::string more =
      missing.size() > 1 ? " and " + std::to_string(missing.size() - 1) + " more" : "";
  return "metadata.yaml names " + text::printable(missing.front()) + more + ", which " +
         (missing.size() > 1 ? "are" : "is") + " not there";
}

std::unique_ptr<MessageSource> open_bag(const fs::path& path) {
  std::vector<fs::path> files = bag_files(path);
  if (files.empty()) throw ReadError(path.string() + ": no bag in it");
  for (const fs::path& file : files) {
    if (kind_by_name(file) != kind_by_name(files.front())) {
      throw ReadError(file.parent_path().string() + ": bags of several kinds, " +
                      files.front().filename().string() + " and " + file.filename().string() +
                      " among them; name the one to read");
    }
  }
  std::error_code ignored;
  const bool is_folder = fs::is_directory(path, ignored);
  const fs::path folder = is_folder ? bag_folder(path) : path;
  const BagMetadata metadata = is_folder ? metadata_in(folder) : BagMetadata{};
  return std::make_unique<BagParts>(std::move(files), missing_files(folder, metadata), metadata);
}

}  // namespace surefoot::io
