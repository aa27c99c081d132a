// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Files that hold one scan each.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/file_kind.hpp"
#include "io/point_table.hpp"

namespace surefoot::io {

enum class ScanFileKind { pcd, ply, kitti_bin, las };

/// The scan files among the kinds of files.
[[nodiscard]] std::optional<ScanFileKind> scan_kind(std::optional<FileKind> kind);
/// By the extension, in any case.
[[nodiscard]] std::optional<ScanFileKind> scan_file_kind(const std::filesystem::path& file);
/// Whether it is a packet capture: .pcap or .pcapng, in any case.
[[nodiscard]] bool is_capture(const std::filesystem::path& file);
/// "PCD", "PLY", "KITTI .bin", "LAS".
[[nodiscard]] const char* name_of(ScanFileKind kind);

/// The points in the bytes of a file. The table looks into `bytes`. Throws ReadError.
[[nodiscard]] PointTable parse_scan_file(ScanFileKind kind, std::span<const std::byte> bytes);

/// Numbers inside names count as numbers: "scan9" before "scan10".
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

}  // namespace surefoot::io
