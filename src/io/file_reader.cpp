// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/file_reader.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

const char* name_of(std::filesystem::file_type type) {
  switch (type) {
    case std::filesystem::file_type::directory:
      return "a folder";
    case std::filesystem::file_type::fifo:
      return "a named pipe";
    case std::filesystem::file_type::socket:
      return "a socket";
    case std::filesystem::file_type::character:
    case std::filesystem::file_type::block:
      return "a device";
    default:
      return "of an unknown kind";
  }
}

}  // namespace

void require_regular_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (error) {
    throw ReadError("cannot read it: " + error.message());
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw ReadError(std::string("it is ") + name_of(status.type()) + "; expected a regular file");
  }
}

void read_whole_file(const std::filesystem::path& file, std::vector<std::byte>& bytes) {
  require_regular_file(file);
  const auto close = [](std::FILE* handle) { std::fclose(handle); };
  errno = 0;
  const std::unique_ptr<std::FILE, decltype(close)> handle(std::fopen(file.c_str(), "rb"), close);
  if (!handle) {
    throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  }
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw ReadError("cannot read it: " + error.message());
  }
  bytes.resize(size);
  std::setvbuf(handle.get(), nullptr, _IONBF, 0);
  if (std::fread(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size()) {
    throw ReadError("could not read all of its " + std::to_string(size) + " bytes");
  }
}

}  // namespace surefoot::io
