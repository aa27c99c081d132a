// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate --picture: a scene and the way through it.
#pragma once

#include <filesystem>

#include "recordings/recording_maker.hpp"

namespace surefoot::recordings {

/// Writes a PNG file.
/// @throws std::invalid_argument for a request that cannot be met, std::runtime_error for files.
void draw_scene(const RecordingRequest& request, const std::filesystem::path& file);

}  // namespace surefoot::recordings
