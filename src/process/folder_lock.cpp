// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "process/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

namespace surefoot::process {

FolderLock::FolderLock(const std::filesystem::path& folder, bool shared)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  const int how = (shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  if (folder_ < 0 || flock(folder_, how) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw std::runtime_error(folder.string() +
                           ": another process is writing to it; choose another folder, or wait");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace surefoot::process
