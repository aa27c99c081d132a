// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/bag_metadata.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "io/ascii_values.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kMostFiles = 100'000;

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string_view trimmed(std::string_view text) {
  text = without_blanks(text);
  const bool quoted = text.size() > 1 && (text.front() == '"' || text.front() == '\'') &&
                      text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

/// A text as it was before YAML put quotes around it.
std::string unquoted(std::string_view text) {
  text = without_blanks(text);
  if (trimmed(text).size() == text.size()) return std::string(text);
  const bool is_double = text.front() == '"';
  std::string result;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool escaped = is_double ? text[i] == '\\' : text.substr(i, 2) == "''";
    if (escaped && i + 2 < text.size()) ++i;
    unsigned code = 0;
    const char* const digits = text.data() + i + 1;
    if (escaped && text[i] == 'n') {
      result += '\n';
    } else if (escaped && text[i] == 'x' && i + 3 < text.size() &&
               std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      result += static_cast<char>(code);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// What follows "key:"; false where the line has another key.
bool value_of(std::string_view line, std::string_view key, std::string_view& value) {
  const std::string_view plain = trimmed(line);
  if (!plain.starts_with(key) || plain.size() <= key.size() || plain[key.size()] != ':') {
    return false;
  }
  value = trimmed(plain.substr(key.size() + 1));
  return true;
}

std::optional<std::uint64_t> count_of(std::string_view text) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(count)
                                                                  : std::nullopt;
}

}  // namespace

BagMetadata parse_bag_metadata(std::string_view text) {
  BagMetadata metadata;
  LineReader reader(text);
  bool in_files = false;
  std::size_t least_indent = std::string_view::npos;
  for (std::string_view line; reader.next(line);) {
    std::string_view value;
    const std::string_view plain = trimmed(line);
    if (in_files && plain.starts_with("- ") && metadata.files.size() < kMostFiles) {
      // A name that leads out of the bag's folder leads nowhere.
      const std::filesystem::path name = unquoted(plain.substr(2));
      if (name.has_filename()) metadata.files.push_back(name.filename().string());
      continue;
    }
    in_files = value_of(line, "relative_file_paths", value);
    // Topics and files have counts, too, further to the right.
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent < least_indent && value_of(line, "message_count", value)) {
      least_indent = indent;
      metadata.messages = count_of(value);
    }
    if (value_of(line, "storage_identifier", value)) metadata.storage = value;
    if (value_of(line, "compression_mode", value)) metadata.compression_mode = value;
  }
  return metadata;
}

}  // namespace surefoot::io
