// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The columns of a table of text, and what their names tell.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "io/ascii_values.hpp"

namespace surefoot::io {

/// Separated by blanks, commas or semicolons.
[[nodiscard]] inline std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = 0;
  while (begin < line.size()) {
    const std::size_t end = std::min(line.find_first_of(", \t\r;", begin), line.size());
    if (end > begin) words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// Whether a column's name is that of a part of a rotation or position: "qw", "q_RS_w" or "w".
[[nodiscard]] inline bool names_part(std::string_view word, char part) {
  if (!word.ends_with(part)) return false;
  const char before = word.size() > 1 ? word[word.size() - 2] : '_';
  return before == 'q' || std::string_view("_./").find(before) != std::string_view::npos;
}

/// Whether a line of columns' names has a quaternion's w before x y z, as EuRoC's q_RS_w has.
[[nodiscard]] inline bool names_w_first(std::string_view line) {
  const std::vector<std::string_view> words = columns_of(line);
  const auto is_part = [](char part) {
    return [part](std::string_view word) { return names_part(word, part); };
  };
  const auto w = std::find_if(words.begin(), words.end(), is_part('w'));
  return std::find_if(w, words.end(), is_part('x')) != words.end() &&
         std::find_if(w, words.end(), is_part('y')) != words.end() &&
         std::find_if(w, words.end(), is_part('z')) != words.end();
}

/// What the lines above the rows say of the order of a rotation's parts.
struct RotationOrder {
  bool is_told = false;
  bool w_first = false;
};
[[nodiscard]] inline RotationOrder rotation_order(std::string_view text) {
  RotationOrder order;
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    const std::vector<std::string_view> words = columns_of(line);
    double ignored = 0.0;
    if (!words.empty() && parse_real(words.front(), ignored)) break;
    order.is_told |= std::any_of(words.begin(), words.end(),
                                 [](std::string_view word) { return names_part(word, 'w'); });
    order.w_first |= names_w_first(line);
  }
  return order;
}

}  // namespace surefoot::io
