// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/bag_files.hpp"

#include <algorithm>

#include "io/ascii_values.hpp"
#include "io/bags/bag_metadata.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/bags/sqlite_bag_reader.hpp"
#include "io/file_reader.hpp"
#include "io/files/scan_files.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

// What rosbag2 wrote beside its files when it closed the bag; nothing in it where it did not.
BagMetadata metadata_in(const fs::path& folder) {
  const fs::path file = folder / "metadata.yaml";
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

// The files that the metadata name, in their order; none where one of them is not there.
std::vector<fs::path> named_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const std::string& name : metadata_in(folder).files) {
    const fs::path plain = folder / name;
    const fs::path compressed = folder / (name + ".zstd");
    std::error_code ignored;
    const bool there = fs::is_regular_file(plain, ignored);
    if (!there && !fs::is_regular_file(compressed, ignored)) return {};
    files.push_back(there ? plain : compressed);
  }
  const bool known = std::all_of(files.begin(), files.end(), is_bag_file);
  return known ? files : std::vector<fs::path>{};
}

// ".mcap" of "a.mcap", "a.MCAP" and "a.mcap.zstd".
fs::path kind_of(const fs::path& file) {
  std::string kind =
      (file.extension() == ".zstd" ? file.stem().extension() : file.extension()).string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return kind;
}

std::unique_ptr<MessageSource> open_part(const fs::path& file) {
  try {
    const fs::path kind = kind_of(file);
    if (kind == ".db3") return read_sqlite_bag(file);
    if (kind == ".bag") return read_ros1_bag(open_stream(file));
    return read_mcap(open_stream(file));
  } catch (const ReadError& error) {
    throw ReadError(file.string() + ": " + error.what());
  }
}

/// The files of a bag one after the other. The last one stays open at its end.
class BagParts final : public MessageSource {
 public:
  explicit BagParts(std::vector<fs::path> files)
      : files_(std::move(files)), part_(open_part(files_.front())) {}

  std::optional<Message> next() override {
    do {
      part_->want(wanted());
      std::optional<Message> message = part_->next();
      take_notes();
      if (message) return message;
    } while (open_next());
    return std::nullopt;
  }

  bool rewind() override { return files_.size() == 1 && part_->rewind(); }
  double progress() const override {
    return (static_cast<double>(index_) + part_->progress()) / static_cast<double>(files_.size());
  }
  std::string format() const override {
    return part_->format() +
           (files_.size() > 1 ? " in " + std::to_string(files_.size()) + " files" : "");
  }

 private:
  void take_notes() {
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

  // False where there is none after this one that can be read.
  bool open_next() {
    while (index_ + 1 < files_.size()) {
      ++index_;
      try {
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
};

}  // namespace

bool is_bag_file(const fs::path& file) {
  const fs::path kind = kind_of(file);
  return kind == ".bag" || kind == ".db3" || kind == ".mcap";
}

std::vector<fs::path> bag_files(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  std::vector<fs::path> files = named_files(path);
  if (!files.empty()) return files;
  for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    const fs::path& file = it->path();
    const bool hidden = file.filename().string().starts_with(".");
    if (it->is_regular_file(ignored) && !hidden && is_bag_file(file)) files.push_back(file);
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return natural_less(a.filename().string(), b.filename().string());
  });
  // A part that lies there compressed and plain is one part.
  std::erase_if(files, [&](const fs::path& file) {
    return file.extension() == ".zstd" &&
           std::find(files.begin(), files.end(), file.parent_path() / file.stem()) != files.end();
  });
  return files;
}

std::unique_ptr<MessageSource> open_bag(std::vector<fs::path> files) {
  for (const fs::path& file : files) {
    if (kind_of(file) != kind_of(files.front())) {
      throw ReadError(file.parent_path().string() + ": bags of several kinds, " +
                      files.front().filename().string() + " and " + file.filename().string() +
                      " among them; name the one to read");
    }
  }
  return std::make_unique<BagParts>(std::move(files));
}

}  // namespace surefoot::io
