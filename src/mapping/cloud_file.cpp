// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/cloud_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace surefoot::mapping {

namespace {

/// Where temporary files go that may be large: /tmp may be memory.
std::filesystem::path temporary_folder() {
  if (const char* wanted = std::getenv("TMPDIR"); wanted != nullptr && *wanted != '\0') {
    return wanted;
  }
  std::error_code ignored;
  return std::filesystem::is_directory("/var/tmp", ignored) ? "/var/tmp" : "/tmp";
}

}  // namespace

std::shared_ptr<CloudFile> CloudFile::make(const std::filesystem::path& folder) {
  const std::filesystem::path where = folder.empty() ? temporary_folder() : folder;
  // Without a name from the start: a signal before `unlink` would leave a named one behind.
  const int nameless = ::open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (nameless >= 0) return std::shared_ptr<CloudFile>(new CloudFile(nameless));
  std::string name = (where / "surefoot-XXXXXX").string();
  const int handle = ::mkostemp(name.data(), O_CLOEXEC);
  if (handle < 0) return nullptr;
  ::unlink(name.c_str());
  return std::shared_ptr<CloudFile>(new CloudFile(handle));
}

std::shared_ptr<CloudFile> CloudFile::open(const std::filesystem::path& file) {
  const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return nullptr;
  return std::shared_ptr<CloudFile>(new CloudFile(handle));
}

CloudFile::~CloudFile() {
  if (!mapped_.empty()) ::munmap(mapped_.data(), mapped_.size());
  ::close(handle_);
}

std::span<std::byte> CloudFile::mapped() {
  if (!mapped_.empty()) ::munmap(mapped_.data(), mapped_.size());
  mapped_ = {};
  if (end_ == 0) return mapped_;
  void* at = ::mmap(nullptr, end_, PROT_READ | PROT_WRITE, MAP_SHARED, handle_, 0);
  if (at != MAP_FAILED) mapped_ = {static_cast<std::byte*>(at), static_cast<std::size_t>(end_)};
  return mapped_;
}

bool CloudFile::append(std::string_view bytes, std::uint64_t& at) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::pwrite(handle_, bytes.data() + done, bytes.size() - done,
                                     static_cast<off_t>(end_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    done += static_cast<std::size_t>(written);
  }
  at = end_;
  end_ += bytes.size();
  return true;
}

std::string CloudFile::read(std::uint64_t at, std::size_t size) const {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got =
        ::pread(handle_, bytes.data() + done, size - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      throw std::runtime_error(std::string("a map's points cannot be read any more: ") +
                               (got < 0 ? std::strerror(errno) : "the file has become shorter"));
    }
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

StoredBytes put_into(const std::shared_ptr<CloudFile>& file, std::string bytes) {
  std::uint64_t at = 0;
  if (file && file->append(bytes, at)) return {file, at, bytes.size()};
  return StoredBytes(std::move(bytes));
}

std::shared_ptr<const StoredCloud> store(const PieceCloud& cloud,
                                         const std::shared_ptr<CloudFile>& file) {
  return std::make_shared<const StoredCloud>(put_into(file, pack(cloud)));
}

}  // namespace surefoot::mapping
