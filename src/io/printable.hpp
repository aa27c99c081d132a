// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace surefoot::io {

/// A text from a file as one line that a terminal can show: control characters become '?'.
[[nodiscard]] inline std::string printable(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool plain = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    line += plain ? c : '?';
  }
  return line;
}

}  // namespace surefoot::io
