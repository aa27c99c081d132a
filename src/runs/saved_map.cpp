// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/saved_map.hpp"

#include <stdexcept>
#include <string>
#include <system_error>

#include "io/file_reader.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "mapping/map_on_disk.hpp"
#include "runs/output_folder.hpp"
#include "runs/run_files.hpp"
#include "text/printable.hpp"

namespace surefoot::runs {

void write_saved_map(const std::filesystem::path& file, const mapping::SavedMap& map) {
  try {
    mapping::store_map(file, map);
  } catch (const std::runtime_error& error) {
    throw io::WriteError(error.what());
  }
}

std::filesystem::path saved_map_file(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? path / kSavedMapFile : path;
}

namespace {

/// A folder without a map: how one is had.
void require_map_in(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored) ||
      std::filesystem::exists(folder / kSavedMapFile, ignored)) {
    return;
  }
  if (!is_run_folder(folder)) {
    throw io::ReadError(folder.string() + ": holds no " + kSavedMapFile +
                        "; expected a folder that surefoot map has written");
  }
  const std::string again =
      std::filesystem::exists(folder / kDescriptionFile, ignored)
          ? "--config " + text::shell_word((folder / kDescriptionFile).string())
          : "INPUT";
  throw io::ReadError(folder.string() + ": holds a run without a " + kSavedMapFile +
                      "; 'surefoot map' makes one of the same recording: surefoot map " + again +
                      " -o FOLDER");
}

}  // namespace

mapping::SavedMap read_saved_map(const std::filesystem::path& path) {
  require_map_in(path);
  const std::filesystem::path file = saved_map_file(path);
  try {
    io::require_regular_file(file);
    return mapping::open_map(file);
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  } catch (const mapping::MapFileError& error) {
    throw io::ReadError(file.string() + " " + error.what() + "; expected what surefoot map wrote");
  } catch (const std::runtime_error& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

MapVersion map_version(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path file = std::filesystem::weakly_canonical(saved_map_file(path));
  return {file, std::filesystem::last_write_time(file, ignored)};
}

}  // namespace surefoot::runs
