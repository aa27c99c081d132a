// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How our pictures come to their place: whole, and known for ours and of their kind, so that an
// earlier one may go for a new one and nothing else does.
#pragma once

#include <filesystem>
#include <string>

#include "report/canvas.hpp"

namespace surefoot::report {

/// A whole file's bytes with the mark that no viewer shows: a comment at the end, in a PNG a chunk
/// of text.
[[nodiscard]] std::string with_mark(std::string bytes, PageFormat format, PictureKind kind);

/// Writes it beside `file` and renames it: there is what was there or the whole new picture. Throws
/// std::runtime_error naming the file and why it could not be written.
void write_picture(const std::filesystem::path& file, const std::string& bytes);

/// To be called before all the work. Throws std::runtime_error where a file, folder or device of
/// this name is there that is no picture of ours of that kind; with `overwrite` any file may go.
void require_picture_or_nothing(const std::filesystem::path& file, PictureKind kind,
                                bool overwrite);

}  // namespace surefoot::report
