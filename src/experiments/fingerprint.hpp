// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Short marks by which one sees that files or a program are still the same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace surefoot::experiments {

/// FNV-1a over what is added to it; for telling versions apart, not for keeping secrets.
class Fingerprint {
 public:
  void add(std::string_view bytes);
  void add(std::uint64_t number);
  [[nodiscard]] std::string text() const;  ///< 16 hexadecimal digits

 private:
  std::uint64_t hash_ = 14695981039346656037U;
};

struct FilesMark {
  std::string fingerprint;
  std::uint64_t bytes = 0;  ///< of all files together
};

/// Of a file, or of a folder's files (not of folders within) and the stamps beside them: names,
/// sizes and times of change, not what is in them. Of a capture what its sensor says of itself,
/// too, which lies in a file beside it. Throws std::filesystem::filesystem_error.
[[nodiscard]] FilesMark mark_of(const std::filesystem::path& path);

/// Of this program's own bytes: changes whenever it is built from other sources. Empty where the
/// system does not show the program's file.
[[nodiscard]] std::string build_fingerprint();

}  // namespace surefoot::experiments
