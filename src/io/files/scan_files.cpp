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

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

}  // namespace

bool is_capture(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".pcap" || extension == ".pcapng";
}

std::optional<ScanFileKind> scan_file_kind(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".pcd") {
    return ScanFileKind::pcd;
  }
  if (extension == ".ply") {
    return ScanFileKind::ply;
  }
  if (extension == ".las" || extension == ".laz") {
    return ScanFileKind::las;
  }
  return extension == ".bin" ? std::optional(ScanFileKind::kitti_bin) : std::nullopt;
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
