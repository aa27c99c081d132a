// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The file in which a run leaves its map, to come back to.
#pragma once

#include <filesystem>

#include "mapping/map_file.hpp"

namespace surefoot::runs {

/// There is the old file or the whole new one. Throws io::WriteError.
void write_saved_map(const std::filesystem::path& file, const mapping::SavedMap& map);
/// The map file itself, of one or of the folder that holds one.
[[nodiscard]] std::filesystem::path saved_map_file(const std::filesystem::path& path);
/// A map file, or the folder that holds one. Throws io::ReadError naming the file.
[[nodiscard]] mapping::SavedMap read_saved_map(const std::filesystem::path& path);

/// Of a map that was asked for: another one where the file is, or has been written since.
struct MapVersion {
  std::filesystem::path file;
  std::filesystem::file_time_type written;
  bool operator==(const MapVersion&) const = default;
};
/// Of the map file, or of the one in the folder.
[[nodiscard]] MapVersion map_version(const std::filesystem::path& path);

}  // namespace surefoot::runs
