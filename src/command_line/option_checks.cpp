// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/option_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string>

namespace surefoot::command_line {

CLI::Validator whole_number(std::uint64_t least) {
  const auto check = [least](std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool good = error == std::errc{} && stop == end && value >= least;
    return good ? std::string()
                : fmt::format("'{}'; expected a whole number of at least {}", text, least);
  };
  return {check, fmt::format(">={}", least)};
}

CLI::Validator number_within(double low, double high) {
  const std::string range = fmt::format("from {} to {}", low, high);
  const auto check = [low, high, range](std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool good = error == std::errc{} && stop == end && value >= low && value <= high;
    return good ? std::string() : fmt::format("'{}'; expected a number {}", text, range);
  };
  return {check, range};
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](std::string& text) {
    const bool known = std::find(words.begin(), words.end(), text) != words.end();
    return known ? std::string()
                 : fmt::format("'{}'; expected one of {}", text, fmt::join(words, ", "));
  };
  return {check, fmt::format("{}", fmt::join(words, "|"))};
}

}  // namespace surefoot::command_line
