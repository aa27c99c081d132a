// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/saved_map.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

#include "io/file_reader.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "runs/run_files.hpp"

namespace surefoot::runs {

void write_saved_map(const std::filesystem::path& file, const mapping::SavedMap& map) {
  io::write_whole_file(file, mapping::format_map(map));
}

std::filesystem::path saved_map_file(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? path / kSavedMapFile : path;
}

mapping::SavedMap read_saved_map(const std::filesystem::path& path) {
  const std::filesystem::path file = saved_map_file(path);
  std::vector<std::byte> bytes;
  try {
    io::read_whole_file(file, bytes);
    return mapping::parse_map(
        std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  } catch (const mapping::MapFileError& error) {
    throw io::ReadError(file.string() + " " + error.what() + "; expected what surefoot map wrote");
  }
}

}  // namespace surefoot::runs
