// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/file_writer.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>

namespace surefoot::io {

void write_whole_file(const std::filesystem::path& file, std::string_view content) {
  std::filesystem::path part = file;
  part += ".part";
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

void append_text(std::string& out, float value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  out.append(text.data(), end);
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
