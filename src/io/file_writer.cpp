// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/file_writer.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace surefoot::io {

bool is_file_beginning(const std::filesystem::path& file, std::string_view text) {
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file))) return false;
  std::string begin(text.size(), '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), std::ssize(begin));
  return begin == text;
}

bool has_ending(const std::filesystem::path& file,
                std::initializer_list<std::string_view> endings) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void require_ending(const std::filesystem::path& file,
                    std::initializer_list<std::string_view> endings) {
  const std::string given = file.extension().string();
  if (given.empty() || has_ending(file, endings)) return;
  std::string expected;
  std::size_t left = endings.size();
  for (const std::string_view one : endings) {
    expected += one;
    if (--left > 0) expected += left == 1 ? " or " : ", ";
  }
  throw std::invalid_argument(file.string() + ": ends with '" + given + "', expected " + expected);
}

void write_whole_file(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path part = file;
  part += kUnfinished;
  std::FILE* handle = std::fopen(part.c_str(), "wb");
  if (handle == nullptr) {
    throw WriteError(file.string() + ": cannot write it: " + std::strerror(errno));
  }
  const bool written = std::fwrite(content.data(), 1, content.size(), handle) == content.size();
  const int write_error = errno;
  const bool closed = std::fclose(handle) == 0;
  std::error_code error;
  if (written && closed) {
    std::filesystem::rename(part, file, error);
  }
  if (!written || !closed || error) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw WriteError(file.string() + ": cannot write it: " +
                     (error ? error.message() : std::strerror(written ? errno : write_error)));
  }
}

UnfinishedOutput::UnfinishedOutput(std::filesystem::path output, bool is_folder)
    : output_(output.has_filename() ? std::move(output) : output.parent_path()), part_(output_) {
  part_ += kUnfinished;
  std::error_code ignored;
  if (is_folder && output_.has_parent_path()) {
    std::filesystem::create_directories(output_.parent_path(), ignored);
  }
  constexpr mode_t kFolder = 0777, kFile = 0666;  // as umask allows
  const bool made = !is_folder || ::mkdir(part_.c_str(), kFolder) == 0 || errno == EEXIST;
  // A link leads to somebody else's.
  const int how = is_folder ? O_RDONLY | O_DIRECTORY : O_RDWR | O_CREAT;
  if (made) lock_ = ::open(part_.c_str(), how | O_NOFOLLOW | O_CLOEXEC, kFile);
  if (lock_ < 0) {
    throw WriteError(part_.string() + ": cannot be made: " + std::strerror(errno));
  }
  const bool taken = ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  // Another may have finished between the two: then what is locked has its name no longer.
  struct stat locked {
  }, named{};
  const bool same = ::fstat(lock_, &locked) == 0 && ::lstat(part_.c_str(), &named) == 0 &&
                    locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
  if (taken || !same) {
    ::close(lock_);
    throw WriteError(part_.string() + ": is there already: another program writes it");
  }
  std::error_code error;
  if (is_folder) {
    for (const auto& left : std::filesystem::directory_iterator(part_, error)) {
      std::filesystem::remove_all(left, error);
    }
  } else if (::ftruncate(lock_, 0) != 0) {
    error = {errno, std::generic_category()};
  }
  if (error) {
    ::close(lock_);
    throw WriteError(part_.string() + ": cannot be made: " + error.message());
  }
}

UnfinishedOutput::~UnfinishedOutput() {
  std::error_code ignored;
  if (!finished_) std::filesystem::remove_all(part_, ignored);
  ::close(lock_);
}

void UnfinishedOutput::finish() {
  // A link of its own is made only where nothing has the name; a folder replaces an empty one.
  std::error_code error;
  if (std::filesystem::is_directory(part_)) {
    std::filesystem::rename(part_, output_, error);
  } else {
    std::filesystem::create_hard_link(part_, output_, error);
    if (!error) {
      std::filesystem::remove(part_, error);
    } else if (error != std::errc::file_exists && !std::filesystem::exists(output_)) {
      std::filesystem::rename(part_, output_, error);  // file systems without links
    }
  }
  if (error) throw WriteError(output_.string() + ": cannot be written: " + error.message());
  finished_ = true;
}

void append_fixed(std::string& out, double value, int decimals) {
  std::array<char, 400> text{};  // the largest double has 309 digits
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::fixed, decimals);
  std::string_view written(text.data(), static_cast<std::size_t>(end - text.data()));
  if (written.starts_with('-') && written.find_first_of("123456789n") == std::string_view::npos) {
    written.remove_prefix(1);
  }
  out.append(written);
}

}  // namespace surefoot::io
