// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// True for .bag, .db3 and .mcap, also with .zstd behind.
[[nodiscard]] bool is_bag_file(const std::filesystem::path& file);

/// The parts of a bag in their order: the file itself, or those of a folder in natural order.
[[nodiscard]] std::vector<std::filesystem::path> bag_files(const std::filesystem::path& path);

/// The messages of one bag, whose parts follow each other. A part after the first that cannot be
/// read is noted and passed over. Throws ReadError naming the file.
[[nodiscard]] std::unique_ptr<MessageSource> open_bag(std::vector<std::filesystem::path> files);

}  // namespace surefoot::io
