// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// Whether it is called as bags are: .bag, .db3, .mcap, also with .zstd, .zst or .active behind.
[[nodiscard]] bool has_bag_name(const std::filesystem::path& file);
/// Whether it is one, by its content or else its name.
[[nodiscard]] bool is_bag_file(const std::filesystem::path& file);

/// Whether rosbag2 made a folder: its metadata lie there.
[[nodiscard]] bool is_rosbag2_folder(const std::filesystem::path& folder);

/// Where a folder's bag lies: in itself, or, where it holds nothing that can be read, in the only
/// folder in it that rosbag2 made, as `surefoot simulate` leaves one beside its truth.
[[nodiscard]] std::filesystem::path bag_folder(const std::filesystem::path& folder);

/// The parts of a bag in their order: the file itself, or those of a folder's bag, as rosbag2's
/// metadata have them or else in natural order.
[[nodiscard]] std::vector<std::filesystem::path> bag_files(const std::filesystem::path& path);

/// Of a folder without any: why, where rosbag2's metadata name some; else empty.
[[nodiscard]] std::string why_no_bag_files(const std::filesystem::path& path);

/// The messages of one bag, the file or the folder of its parts, which follow each other. A part
/// after the first that cannot be read is noted and passed over; so is, at the end, what rosbag2's
/// metadata promise besides. Throws ReadError naming the file.
[[nodiscard]] std::unique_ptr<MessageSource> open_bag(const std::filesystem::path& path);

}  // namespace surefoot::io
