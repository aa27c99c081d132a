// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// By what our pictures are known for ours, so that an earlier one may go for a new one and nothing
// else does.
#pragma once

#include <filesystem>
#include <string>

#include "report/canvas.hpp"

namespace surefoot::report {

/// A whole file's bytes with the mark that no viewer shows: a comment at the end, in a PNG a chunk
/// of text.
[[nodiscard]] std::string with_mark(std::string bytes, PageFormat format);

/// To be called before all the work. Throws std::runtime_error where a file, folder or device of
/// this name is there that is no picture of ours; with `overwrite` any file may go.
void require_picture_or_nothing(const std::filesystem::path& file, bool overwrite);

}  // namespace surefoot::report
