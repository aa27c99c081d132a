// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

namespace surefoot::io {

/// A file could not be written. The message names it and says why.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the name of something ends with that is not whole yet; a name that nobody else gives.
inline constexpr const char* kUnfinished = ".surefoot-part";

/// A file or folder that takes its name once it is whole, and nobody else's: until then it is
/// beside it, with kUnfinished behind its name, and goes where it is not finished. What a killed
/// program left is taken over: it is locked while somebody writes it.
class UnfinishedOutput {
 public:
  /// Makes it, empty. Throws WriteError, also where another program writes it.
  UnfinishedOutput(std::filesystem::path output, bool is_folder);
  ~UnfinishedOutput();
  UnfinishedOutput(const UnfinishedOutput&) = delete;
  UnfinishedOutput& operator=(const UnfinishedOutput&) = delete;
  /// Where to write it.
  [[nodiscard]] const std::filesystem::path& path() const { return part_; }
  /// Gives it its name; throws WriteError where something other than an empty folder has that.
  void finish();

 private:
  std::filesystem::path output_, part_;
  int lock_ = -1;
  bool finished_ = false;
};

/// Whether this is a regular file, no link to one, that begins so: by a mark of ours it is ours.
[[nodiscard]] bool is_file_beginning(const std::filesystem::path& file, std::string_view text);

/// Whether the file's name ends with one of these, in capitals or not.
[[nodiscard]] bool has_ending(const std::filesystem::path& file,
                              std::initializer_list<std::string_view> endings);

/// What is written goes by the file's name, which must not say something else: throws
/// std::invalid_argument that names the endings where it has another one than these. A name without
/// any says nothing.
void require_ending(const std::filesystem::path& file,
                    std::initializer_list<std::string_view> endings);

/// Writes beside `file` and renames, so that there is the old file or the whole new one, never half
/// of one. Throws WriteError.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// Appends the bytes of a number as this (little-endian) machine has them.
template <typename T>
void append_bytes(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Appends with a fixed number of decimals, without a minus sign before zero.
void append_fixed(std::string& out, double value, int decimals);

}  // namespace surefoot::io
