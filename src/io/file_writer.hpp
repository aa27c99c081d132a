// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace surefoot::io {

/// A file could not be written. The message names it and says why.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes beside `file` and renames, so that there is the old file or the whole new one, never half
/// of one. Throws WriteError.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// Appends the bytes of a number as this (little-endian) machine has them.
template <typename T>
void append_bytes(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Appends the shortest decimal text that reads back as the same float; "nan" and "inf" as such.
void append_text(std::string& out, float value);
/// Appends with a fixed number of decimals, without a minus sign before zero.
void append_fixed(std::string& out, double value, int decimals);

}  // namespace surefoot::io
