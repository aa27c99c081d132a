// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Inputs that come through a pipe (/dev/stdin, a shell's <(...)): they go to a temporary file
// first, since what is read is looked at before.
#pragma once

#include <filesystem>

namespace surefoot::app {

/// Of a recording, which has to begin as one. Throws io::ReadError, std::runtime_error.
void take_piped_recording(const std::filesystem::path& input, bool quiet);
/// Of a trajectory; nothing happens where no path is given. Throws std::runtime_error.
void take_piped_text(const std::filesystem::path& input);

}  // namespace surefoot::app
