// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where the pieces' clouds are while nobody looks at them: in a file without a name, in a map's
// file, or, where there is none, in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mapping/packed_cloud.hpp"

namespace surefoot::mapping {

/// An open file that clouds are read from, by several threads if need be.
class CloudFile {
 public:
  /// A new one without a name, in this folder (empty: where temporary files go); gone with the
  /// program. Null if none can be made there.
  [[nodiscard]] static std::shared_ptr<CloudFile> make(const std::filesystem::path& folder);
  /// One that is there. Null if it cannot be opened.
  [[nodiscard]] static std::shared_ptr<CloudFile> open(const std::filesystem::path& file);
  ~CloudFile();
  CloudFile(const CloudFile&) = delete;
  CloudFile& operator=(const CloudFile&) = delete;

  /// Where in the file the bytes are now; false if the disk is full.
  [[nodiscard]] bool append(std::string_view bytes, std::uint64_t& at);
  /// Throws std::runtime_error if they cannot be read any more.
  [[nodiscard]] std::string read(std::uint64_t at, std::size_t size) const;
  /// What was appended so far, to read and to change: memory that the system takes back where it is
  /// short of it. Until this is called again or the file is gone; empty if there is nothing or it
  /// cannot be shown so.
  [[nodiscard]] std::span<std::byte> mapped();

 private:
  explicit CloudFile(int handle) : handle_(handle) {}

  int handle_;
  std::uint64_t end_ = 0;
  std::span<std::byte> mapped_;
};

/// Bytes, wherever they are.
class StoredBytes {
 public:
  /// In memory.
  explicit StoredBytes(std::string bytes) : bytes_(std::move(bytes)) {}
  /// In a file.
  StoredBytes(std::shared_ptr<const CloudFile> file, std::uint64_t at, std::size_t size)
      : file_(std::move(file)), at_(at), size_(size) {}

  /// Throws std::runtime_error if the file cannot be read any more.
  [[nodiscard]] std::string packed() const { return file_ ? file_->read(at_, size_) : bytes_; }

 private:
  std::string bytes_;
  std::shared_ptr<const CloudFile> file_;
  std::uint64_t at_ = 0;
  std::size_t size_ = 0;
};

/// A packed cloud: as pack() has written it.
class StoredCloud : public StoredBytes {
 public:
  using StoredBytes::StoredBytes;
  explicit StoredCloud(StoredBytes bytes) : StoredBytes(std::move(bytes)) {}
  [[nodiscard]] PieceCloud cloud() const { return unpack(packed()); }
};

/// Packs a cloud away, into the file if there is one.
[[nodiscard]] std::shared_ptr<const StoredCloud> store(const PieceCloud& cloud,
                                                       const std::shared_ptr<CloudFile>& file);
/// Puts bytes away, into the file if there is one.
[[nodiscard]] StoredBytes put_into(const std::shared_ptr<CloudFile>& file, std::string bytes);

}  // namespace surefoot::mapping
