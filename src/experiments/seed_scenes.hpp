// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which recordings are seeds of one scene: those whose scene.json says the same but for the seed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace surefoot::experiments {

/// For each recording (a folder, or a file in it) the name of its scene and robot,
/// "campus-trot". Recordings have the same name if, and only if, they were made alike: scene,
/// robot, LiDAR, mount, number of scans, all but the seed. Empty for one without a scene.json that
/// tells this.
[[nodiscard]] std::vector<std::string> seed_scenes(
    const std::vector<std::filesystem::path>& recordings);

}  // namespace surefoot::experiments
