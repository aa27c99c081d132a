// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_on_disk.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace surefoot::mapping {

SavedMap load_map(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path file = folder ? path / kMapFileName : path;
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  try {
    return parse_map(bytes);
  } catch (const MapFileError& error) {
    throw std::runtime_error(file.string() + " " + error.what() +
                             "; expected what surefoot map or Mapper::save() wrote");
  }
}

void store_map(const std::filesystem::path& file, const SavedMap& map) {
  std::filesystem::path part = file;
  part += ".part";
  const std::string bytes = format_map(map);
  std::error_code error;
  std::ofstream stream(part, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) std::filesystem::rename(part, file, error);
  if (stream && !error) return;
  const int why = errno;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw std::runtime_error(file.string() + ": cannot be written" + ": " +
                           (error ? error.message() : std::strerror(why)));
}

}  // namespace surefoot::mapping
