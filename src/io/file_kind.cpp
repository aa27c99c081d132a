// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/file_kind.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bags/compression.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

using namespace std::string_view_literals;

constexpr std::array<std::pair<std::string_view, FileKind>, 14> kBeginnings = {{
    {"#ROSBAG V"sv, FileKind::ros1_bag},
    {"SQLite format 3\0"sv, FileKind::sqlite_bag},
    {"\x89MCAP"sv, FileKind::mcap},
    {"\xd4\xc3\xb2\xa1"sv, FileKind::capture},  // pcap, microseconds and nanoseconds
    {"\xa1\xb2\xc3\xd4"sv, FileKind::capture},
    {"\x4d\x3c\xb2\xa1"sv, FileKind::capture},
    {"\xa1\xb2\x3c\x4d"sv, FileKind::capture},
    {"\x0a\x0d\x0d\x0a"sv, FileKind::capture},  // pcapng
    {"# .PCD"sv, FileKind::pcd},
    {"VERSION ."sv, FileKind::pcd},
    {"VERSION 0"sv, FileKind::pcd},
    {"ply\n"sv, FileKind::ply},
    {"ply\r"sv, FileKind::ply},
    {"LASF"sv, FileKind::las},
}};

constexpr std::array<std::pair<std::string_view, FileKind>, 10> kExtensions = {{
    {".bag", FileKind::ros1_bag},
    {".db3", FileKind::sqlite_bag},
    {".mcap", FileKind::mcap},
    {".pcap", FileKind::capture},
    {".pcapng", FileKind::capture},
    {".pcd", FileKind::pcd},
    {".ply", FileKind::ply},
    {".las", FileKind::las},
    {".laz", FileKind::las},
    {".bin", FileKind::kitti_bin},
}};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

}  // namespace

std::optional<FileKind> kind_by_content(std::span<const std::byte> begin) {
  const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
  for (const auto& [beginning, kind] : kBeginnings) {
    if (text.starts_with(beginning)) return kind;
  }
  return std::nullopt;
}

bool is_recording_begin(std::span<const std::byte> begin) {
  return kind_by_content(begin) || compression_by_content(begin) != Compression::none;
}

bool is_lfs_pointer(std::span<const std::byte> begin) {
  const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
  return text.starts_with("version https://git-lfs");
}

std::filesystem::path uncompressed_name(const std::filesystem::path& file) {
  const std::string extension = lower_case(file.extension().string());
  for (const char* const one : {".zstd", ".zst", ".gz", ".bz2", ".lz4"}) {
    if (extension == one) return file.parent_path() / file.stem();
  }
  return file;
}

std::optional<FileKind> kind_by_name(const std::filesystem::path& file) {
  const std::filesystem::path plain = uncompressed_name(file);
  const bool compressed = plain != file;
  std::filesystem::path name = lower_case(plain.filename().string());
  const bool active = name.extension() == ".active";
  if (active) name = name.stem();
  for (const auto& [extension, kind] : kExtensions) {
    if (name.extension() != extension) continue;
    const bool may_be = (!compressed || may_be_compressed(kind)) && (!active || is_bag_kind(kind));
    return may_be ? std::optional(kind) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<FileKind> kind_of(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return kind_by_name(file);
  try {
    std::array<std::byte, kTellingBytes> begin{};
    FileStream stream(file);
    std::span<const std::byte> bytes = std::span(begin).first(stream.read(begin));
    const bool compressed = compression_by_content(bytes) != Compression::none;
    if (compressed) bytes = std::span(begin).first(open_stream(file)->read(begin));
    const auto kind = kind_by_content(bytes);
    if (kind && (!compressed || may_be_compressed(kind))) return kind;
  } catch (const ReadError&) {
    // Whoever reads it says so.
  }
  return kind_by_name(file);
}

}  // namespace surefoot::io
