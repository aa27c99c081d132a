// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A pipe that is read as a file: what comes through it goes to the disk first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace surefoot::process {

/// Throws what refuses a pipe by its first bytes: one without an end would fill the disk.
using PipeJudge = std::function<void(std::span<const std::byte> begin)>;
inline constexpr std::size_t kJudgedBytes = 512;

/// Where `path` names an open pipe of this program (/dev/stdin, or the /dev/fd/63 of a shell's
/// <(...)), a file with all that comes through it takes the pipe's place: the same path is then a
/// regular file, to be opened as often as one likes. It lies in the temporary folder without a
/// name, so that it is gone with the program, however that ends. Returns its bytes; nothing where
/// the path is something else, also a named pipe, whose writer may never come. Throws
/// std::runtime_error naming the path.
[[nodiscard]] std::optional<std::uint64_t> make_file_of_pipe(const std::filesystem::path& path,
                                                             const PipeJudge& judge);

}  // namespace surefoot::process
