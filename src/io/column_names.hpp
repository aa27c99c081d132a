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

/// Where the parts of a rotation begin among the names of columns, in this order: "qw", "q_RS_w" or
/// "w" and the same with x, y and z. Their number if they are not there.
[[nodiscard]] inline std::size_t find_parts(const std::vector<std::string_view>& names,
                                            std::string_view order) {
  const auto stem_of = [](std::string_view name) { return name.substr(0, name.size() - 1); };
  for (std::size_t begin = 0; begin + order.size() <= names.size(); ++begin) {
    bool all = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::string_view name = names[begin + i];
      all = all && name.back() == order[i] && stem_of(name) == stem_of(names[begin]);
    }
    const std::string_view stem = stem_of(names[begin]);
    const bool is_apart = stem.empty() || stem.back() == 'q' ||
                          std::string_view("_./").find(stem.back()) != std::string_view::npos;
    if (all && is_apart) return begin;
  }
  return names.size();
}

/// Of a line of columns' names; units in brackets are none.
[[nodiscard]] inline std::vector<std::string_view> names_in(std::string_view line) {
  std::vector<std::string_view> names = columns_of(line);
  std::erase_if(names, [](std::string_view word) { return word.starts_with('['); });
  return names;
}

/// Whether a line of columns' names has a quaternion's w before x y z, as EuRoC's q_RS_w has.
[[nodiscard]] inline bool names_w_first(std::string_view line) {
  const std::vector<std::string_view> names = names_in(line);
  return find_parts(names, "wxyz") < names.size();
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
    const std::vector<std::string_view> names = names_in(line);
    order.w_first |= names_w_first(line);
    order.is_told |= order.w_first || find_parts(names, "xyzw") < names.size();
  }
  return order;
}

}  // namespace surefoot::io
