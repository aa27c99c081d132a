// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace surefoot::io {

/// Whether ROS lets a topic have that name: "/points", "points", "/robot_1/points".
[[nodiscard]] constexpr bool is_topic_name(std::string_view topic) {
  if (topic.starts_with('/')) topic.remove_prefix(1);
  char before = '/';
  for (const char letter : topic) {
    const bool is_digit = letter >= '0' && letter <= '9';
    const bool is_letter =
        (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
    if (!is_letter && (before == '/' || !(is_digit || letter == '/'))) return false;
    before = letter;
  }
  return before != '/';
}

}  // namespace surefoot::io
