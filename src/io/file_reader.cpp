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

struct Close {
  void operator()(std::FILE* handle) const { std::fclose(handle); }
};
using OpenFile = std::unique_ptr<std::FILE, Close>;

OpenFile opened(const std::filesystem::path& file) {
  require_regular_file(file);
  errno = 0;
  OpenFile handle(std::fopen(file.c_str(), "rb"));
  if (!handle) {
    throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  }
  std::setvbuf(handle.get(), nullptr, _IONBF, 0);
  return handle;
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
  const OpenFile handle = opened(file);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw ReadError("cannot read it: " + error.message());
  }
  bytes.resize(size);
  if (std::fread(bytes.data(), 1, bytes.size(), handle.get()) != bytes.size()) {
    throw ReadError("could not read all of its " + std::to_string(size) + " bytes");
  }
}

void read_lines_in_parts(const std::filesystem::path& file,
                         const std::function<void(std::string_view lines)>& use) {
  constexpr std::size_t kPart = 1 << 20;
  const OpenFile handle = opened(file);
  std::string text;
  for (std::size_t got = kPart; got == kPart;) {
    const std::size_t begun = text.size();  // a line that the last part has the beginning of
    text.resize(begun + kPart);
    got = std::fread(text.data() + begun, 1, kPart, handle.get());
    text.resize(begun + got);
    if (std::ferror(handle.get()) != 0) throw ReadError("could not read all of it");
    const std::size_t end = got == kPart ? text.rfind('\n') + 1 : text.size();  // npos + 1: 0
    use(std::string_view(text).substr(0, end));
    text.erase(0, end);
  }
}

}  // namespace surefoot::io
