// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace surefoot::io {

/// Throws ReadError saying what `file` is if it is no regular file: opening a pipe may wait for
/// ever, and a device has no size.
void require_regular_file(const std::filesystem::path& file);

/// A whole regular file into `bytes`, whose memory is used again. Throws ReadError.
void read_whole_file(const std::filesystem::path& file, std::vector<std::byte>& bytes);

/// A regular file of text, some whole lines at a time, so that it is never in memory as a whole;
/// only a line that is longer than a megabyte makes a part longer. Throws ReadError.
void read_lines_in_parts(const std::filesystem::path& file,
                         const std::function<void(std::string_view lines)>& use);

}  // namespace surefoot::io
