// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// LZ4 frames, Zstandard frames and bzip2, as bags have them, and gzip, as whole files do.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bags/byte_stream.hpp"

namespace surefoot::io {

enum class Compression { none, lz4, zstd, bzip2, gzip };

/// "", "none", "lz4", "zstd", "bz2"; nothing for another name.
[[nodiscard]] std::optional<Compression> compression_named(std::string_view name);

/// What `compressed` holds, decompressed while it is read with memory of a fixed size; several
/// frames may follow each other. Where the compressed bytes end too early, what they held until
/// then is there. Not for none. `compressed` must outlive the stream.
[[nodiscard]] std::unique_ptr<ByteStream> decompress(Compression compression,
                                                     ByteStream& compressed);

/// Where a message is decompressed from, and how many compressed bytes a decoder may hold that it
/// has not decoded yet.
struct CompressedSource {
  const LimitedStream& compressed;
  std::uint64_t read_ahead = 0;
};

/// The most bytes that a message can honestly have that so many compressed ones hold [bytes]: of
/// sweeps, 32 times as many come of those that are nearly all NaN. Small ones may be more.
[[nodiscard]] std::uint64_t most_from(std::uint64_t compressed);
inline constexpr std::string_view kTooDense =
    "it is more than 32 times as large as what it is compressed into";

/// True where the bytes begin as a Zstandard frame does.
[[nodiscard]] bool is_zstd(std::span<const std::byte> bytes);

/// What bytes that begin so are compressed with: none where they do not tell.
[[nodiscard]] Compression compression_by_content(std::span<const std::byte> begin);

/// A file's bytes; those that it holds, where it is compressed as a whole (its first bytes say so).
/// Throws ReadError without the file's name.
[[nodiscard]] std::unique_ptr<ByteStream> open_stream(const std::filesystem::path& file);

/// Messages that rosbag2 compressed one by one, in a database or in MCAP. Nothing in the file says
/// so: each is a Zstandard frame, which no message in CDR begins as.
class CompressedMessages {
 public:
  /// The message as it was, until the next call; nothing where it is damaged or too large, which
  /// problem() tells of.
  [[nodiscard]] std::optional<std::span<const std::byte>> plain(std::span<const std::byte> message);
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// Whether one of them was compressed.
  [[nodiscard]] bool any() const { return any_; }

 private:
  std::vector<std::byte> plain_;
  std::string problem_;
  bool any_ = false;
};

/// One frame that holds `bytes`. none, lz4, zstd.
[[nodiscard]] std::string compress(Compression compression, std::string_view bytes);

}  // namespace surefoot::io
