// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate --animation: scan and gait as a moving picture.
#pragma once

#include <filesystem>

#include "recordings/recording_maker.hpp"

namespace surefoot::recordings {

/// Draws four turns of the LiDAR while the robot walks, in slow motion, as an animated PNG.
/// @throws std::invalid_argument for a request that cannot be met, std::runtime_error for files.
void draw_animation(const RecordingRequest& request, const std::filesystem::path& file);

}  // namespace surefoot::recordings
