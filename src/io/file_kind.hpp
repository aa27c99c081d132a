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
/// By the extension in any case, also before ".zstd", ".zst" and ".active" (a bag that is not
/// closed).
[[nodiscard]] std::optional<FileKind> kind_by_name(const std::filesystem::path& file);
/// By the content of a regular file, that of a bag also within Zstandard; else by the name.
[[nodiscard]] std::optional<FileKind> kind_of(const std::filesystem::path& file);

[[nodiscard]] constexpr bool is_bag_kind(std::optional<FileKind> kind) {
  return kind == FileKind::ros1_bag || kind == FileKind::sqlite_bag || kind == FileKind::mcap;
}

}  // namespace surefoot::io
