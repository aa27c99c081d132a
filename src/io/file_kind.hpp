// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a file is: by how it begins, which goes before what it is called.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace surefoot::io {

enum class FileKind { ros1_bag, sqlite_bag, mcap, capture, pcd, ply, las, kitti_bin };

/// So many bytes tell.
inline constexpr std::size_t kTellingBytes = 32;

/// Nothing where they do not tell, as KITTI's, which are numbers alone.
[[nodiscard]] std::optional<FileKind> kind_by_content(std::span<const std::byte> begin);
/// Whether a file that begins so may be a recording: one of the above, or compressed.
[[nodiscard]] bool is_recording_begin(std::span<const std::byte> begin);
/// Whether a file that begins so is what Git LFS has in place of one that was not fetched.
[[nodiscard]] bool is_lfs_pointer(std::span<const std::byte> begin);
inline constexpr const char* kLfsPointer =
    "what Git LFS has in place of the file; 'git lfs pull' fetches it";
/// By the extension in any case, of a bag and a capture also before ".zst", ".gz" and their like,
/// of a bag before ".active" (one that is not closed).
[[nodiscard]] std::optional<FileKind> kind_by_name(const std::filesystem::path& file);
/// By the content of a regular file, that of a bag or capture also where it is compressed as a
/// whole; else by the name.
[[nodiscard]] std::optional<FileKind> kind_of(const std::filesystem::path& file);

/// The name of a file without the ending that says it is compressed.
[[nodiscard]] std::filesystem::path uncompressed_name(const std::filesystem::path& file);

[[nodiscard]] constexpr bool is_bag_kind(std::optional<FileKind> kind) {
  return kind == FileKind::ros1_bag || kind == FileKind::sqlite_bag || kind == FileKind::mcap;
}
/// Whether files of the kind are read where they are compressed as a whole, too.
[[nodiscard]] constexpr bool may_be_compressed(std::optional<FileKind> kind) {
  return is_bag_kind(kind) || kind == FileKind::capture;
}

}  // namespace surefoot::io
