// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/scan_files.hpp"

#include <algorithm>

#include "io/files/kitti_bin.hpp"
#include "io/files/las.hpp"
#include "io/files/pcd_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

// The run of digits at `at`, without leading zeros; moves `at` past it.
std::string_view take_digits(std::string_view text, std::size_t& at) {
  while (at < text.size() && text[at] == '0') {
    ++at;
  }
  const std::size_t begin = at;
  while (at < text.size() && is_decimal_digit(text[at])) {
    ++at;
  }
  return text.substr(begin, at - begin);
}

}  // namespace

bool is_capture(const std::filesystem::path& file) {
  return kind_by_name(file) == FileKind::capture;
}

std::optional<ScanFileKind> scan_kind(std::optional<FileKind> kind) {
  if (!kind) return std::nullopt;
  switch (*kind) {
    case FileKind::pcd:
      return ScanFileKind::pcd;
    case FileKind::ply:
      return ScanFileKind::ply;
    case FileKind::kitti_bin:
      return ScanFileKind::kitti_bin;
    case FileKind::las:
      return ScanFileKind::las;
    default:
      return std::nullopt;
  }
}

std::optional<ScanFileKind> scan_file_kind(const std::filesystem::path& file) {
  return scan_kind(kind_by_name(file));
}

const char* name_of(ScanFileKind kind) {
  switch (kind) {
    case ScanFileKind::pcd:
      return "PCD";
    case ScanFileKind::ply:
      return "PLY";
    case ScanFileKind::kitti_bin:
      return "KITTI .bin";
    case ScanFileKind::las:
      return "LAS";
  }
  return "";
}

PointTable parse_scan_file(ScanFileKind kind, std::span<const std::byte> bytes) {
  if (bytes.empty()) {
    throw ReadError(std::string("empty file; expected ") + name_of(kind));
  }
  if (is_lfs_pointer(bytes)) throw ReadError(kLfsPointer);
  switch (kind) {
    case ScanFileKind::pcd:
      return parse_pcd(bytes);
    case ScanFileKind::ply:
      return parse_ply(bytes);
    case ScanFileKind::kitti_bin:
      return parse_kitti_bin(bytes);
    case ScanFileKind::las:
      return parse_las(bytes);
  }
  return {};
}

bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_decimal_digit(a[i]) && is_decimal_digit(b[j])) {
      const std::string_view left = take_digits(a, i);
      const std::string_view right = take_digits(b, j);
      if (left != right) {
        return left.size() != right.size() ? left.size() < right.size() : left < right;
      }
      continue;
    }
    if (a[i] != b[j]) {
      return a[i] < b[j];
    }
    ++i;
    ++j;
  }
  const bool both_ended = i == a.size() && j == b.size();
  return both_ended ? a < b : i == a.size();
}

}  // namespace surefoot::io
