// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Bytes from front to back, without a seek: a file, a part of another stream, memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace surefoot::io {

class ByteStream {
 public:
  virtual ~ByteStream() = default;
  /// Fills `to` from what comes next; fewer bytes only where the stream ends. Throws ReadError
  /// where the bytes cannot be read or are not what their format asks for.
  virtual std::size_t read(std::span<std::byte> to) = 0;
  /// Passes over bytes; fewer only where the stream ends.
  virtual std::uint64_t skip(std::uint64_t count);
  /// Share of the underlying file that was read, 0..1; 0 where that is not known.
  [[nodiscard]] virtual double progress() const { return 0.0; }
};

/// A regular file, also one that grows or is larger than memory.
class FileStream final : public ByteStream {
 public:
  /// Throws ReadError without the file's name.
  explicit FileStream(const std::filesystem::path& file);
  std::size_t read(std::span<std::byte> to) override;
  [[nodiscard]] double progress() const override;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
};

class MemoryStream final : public ByteStream {
 public:
  explicit MemoryStream(std::span<const std::byte> bytes) : rest_(bytes) {}
  std::size_t read(std::span<std::byte> to) override;

 private:
  std::span<const std::byte> rest_;
};

/// The next `size` bytes of another stream, which must outlive it.
class LimitedStream final : public ByteStream {
 public:
  LimitedStream(ByteStream& whole, std::uint64_t size) : whole_(whole), left_(size) {}
  std::size_t read(std::span<std::byte> to) override;
  std::uint64_t skip(std::uint64_t count) override;
  [[nodiscard]] std::uint64_t left() const { return left_; }
  void set_left(std::uint64_t left) { left_ = left; }

 private:
  ByteStream& whole_;
  std::uint64_t left_;
};

/// Another stream, of which a part can be looked at before it is read.
class LookAheadStream final : public ByteStream {
 public:
  explicit LookAheadStream(ByteStream& whole) : whole_(whole) {}
  std::size_t read(std::span<std::byte> to) override;
  /// Fills `to` from what comes after `offset` more bytes, which are kept in memory until they are
  /// read; returns how many there are.
  std::size_t peek(std::size_t offset, std::span<std::byte> to);

 private:
  ByteStream& whole_;
  std::vector<std::byte> ahead_;
  std::size_t next_ = 0;  ///< of those
};

/// Reads what another stream holds and keeps its CRC-32 (IEEE).
class ChecksumStream final : public ByteStream {
 public:
  explicit ChecksumStream(ByteStream& whole) : whole_(whole) {}
  std::size_t read(std::span<std::byte> to) override;
  [[nodiscard]] std::uint32_t crc() const { return crc_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  ByteStream& whole_;
  std::uint32_t crc_ = 0;
  std::uint64_t size_ = 0;
};

/// CRC-32 (IEEE) of `bytes`, going on from that of what came before.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

/// Exactly `size` bytes into `buffer`, which grows as bytes come and not by what a header says, and
/// whose memory is used again. Nothing where the stream ends before.
[[nodiscard]] std::optional<std::span<const std::byte>> read_bytes(ByteStream& stream,
                                                                   std::uint64_t size,
                                                                   std::vector<std::byte>& buffer);

/// All that is left, but no more than `most` bytes.
[[nodiscard]] std::span<const std::byte> read_all(ByteStream& stream,
                                                  std::vector<std::byte>& buffer, std::size_t most);

}  // namespace surefoot::io
