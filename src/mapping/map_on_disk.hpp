// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Map files by their paths, for who has the library alone.
#pragma once

#include <filesystem>

#include "mapping/map_file.hpp"

namespace surefoot::mapping {

/// The name of the map in a run's folder.
inline constexpr const char* kMapFileName = "map.surefoot";

/// A map file, or the folder that holds one as map.surefoot. Throws std::runtime_error that names
/// it.
[[nodiscard]] SavedMap load_map(const std::filesystem::path& path);
/// A map file; clouds stay in it until they are asked for. Throws MapFileError for what is in it,
/// std::runtime_error that says why it cannot be read; neither names it.
[[nodiscard]] SavedMap open_map(const std::filesystem::path& file);
/// There is the old file or the whole new one. Throws std::runtime_error that names it.
void store_map(const std::filesystem::path& file, const SavedMap& map);

}  // namespace surefoot::mapping
