// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/yaml_word.hpp"

namespace surefoot::io {
namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// No word of YAML's, such as no or null, and no number: those have no slash, and no letter first
/// and a dot.
bool is_plain(std::string_view text) {
  const auto is_letter = [](char c) { return kLetters.find(c) != std::string_view::npos; };
  for (const char c : text) {
    constexpr std::string_view kOthers = "0123456789/_.";
    if (!is_letter(c) && kOthers.find(c) == std::string_view::npos) return false;
  }
  return text.find('/') != std::string_view::npos ||
         (!text.empty() && is_letter(text.front()) && text.find('.') != std::string_view::npos);
}

}  // namespace

std::string yaml_word(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  std::string word = "\"";
  for (const char c : text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n') {
      word += "\\n";
    } else if (code < 0x20 || code == 0x7f) {
      word += {'\\', 'x', kDigits[code >> 4], kDigits[code & 15]};
    } else {
      if (c == '"' || c == '\\') word += '\\';
      word += c;
    }
  }
  return word + '"';
}

}  // namespace surefoot::io
