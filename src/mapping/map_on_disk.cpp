// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_on_disk.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

namespace surefoot::mapping {

namespace {

/// Until it is, a power cut may leave a file's name without what was written to it; false where the
/// disk says that it is not.
bool reaches_disk(const std::filesystem::path& path) {
  const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return false;
  const bool reached = ::fsync(handle) == 0 || errno == EINVAL;  // a file system without
  const int why = errno;
  ::close(handle);
  errno = why;
  return reached;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

SavedMap open_map(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  const std::shared_ptr<CloudFile> clouds = CloudFile::open(file);
  if (!stream || !clouds) {
    throw std::runtime_error(std::string("cannot read it: ") + std::strerror(errno));
  }
  return read_map(stream, clouds);
}

SavedMap load_map(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path file = folder ? path / kMapFileName : path;
  try {
    return open_map(file);
  } catch (const MapFileError& error) {
    throw std::runtime_error(file.string() + " " + error.what() +
                             "; expected what surefoot map or Mapper::save() wrote");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

void store_map(const std::filesystem::path& file, const SavedMap& map) {
  std::filesystem::path part = file;
  part += ".surefoot-part";
  std::error_code error, ignored;
  std::ofstream stream(part, std::ios::binary);
  try {
    write_map(stream, map);
  } catch (...) {
    std::filesystem::remove(part, ignored);
    throw;
  }
  stream.close();
  const bool written = stream && reaches_disk(part);
  if (written) std::filesystem::rename(part, file, error);
  if (written && !error) {
    (void)reaches_disk(folder_of(file));  // a folder that cannot be opened has it all the same
    return;
  }
  const int why = errno;
  std::filesystem::remove(part, ignored);
  throw std::runtime_error(file.string() + ": cannot be written" + ": " +
                           (error ? error.message() : std::strerror(why)));
}

}  // namespace surefoot::mapping
