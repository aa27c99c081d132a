// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "text/utf8.hpp"

namespace surefoot::text {

/// A text from a file as one line that a terminal can show: control characters, also those of
/// two bytes (U+0080 to U+009F), and what is no UTF-8 become '?'.
[[nodiscard]] inline std::string printable(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    const std::string_view letter = text.substr(at, length);
    const bool is_control = length == 1 ? letter[0] < 0x20 || letter[0] == 0x7f
                                        : letter >= "\xC2\x80" && letter <= "\xC2\x9F";
    line += length == 0 || is_control ? "?" : letter;
    at += length == 0 ? 1 : length;
  }
  return line;
}

/// The same for a text of several lines.
[[nodiscard]] inline std::string printable_lines(std::string_view text) {
  std::string lines;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n')) {
    lines += printable(text.substr(0, end)) + "\n";
    text.remove_prefix(end + 1);
  }
  return lines + printable(text);
}

/// The same as one word of a command that can be pasted into a shell, whatever the text holds.
[[nodiscard]] inline std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+=:,@%";
  std::string line = printable(text);
  if (!line.empty() && line.find_first_not_of(kPlain) == std::string::npos) return line;
  std::string word = "'";
  for (const char c : line) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace surefoot::text
