// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace surefoot::command_line {

/// Type name of options that name a file to be read.
inline constexpr const char* kFileType = "FILE";

/// For options of unsigned type: a whole number of at least `least`. CLI11 by itself reads -1 as
/// the greatest number there is.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least);

/// A number from `low` to `high`. CLI::Range lets NaN pass.
[[nodiscard]] CLI::Validator number_within(double low, double high);

/// One of these words.
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& words);

/// An option whose values are words that stand for `Choice`s. `choice` must live until the command
/// line is parsed.
template <typename Choice>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, Choice& choice,
                        const std::string& help,
                        const std::vector<std::pair<std::string, Choice>>& words) {
  std::vector<std::string> names(words.size());
  std::transform(words.begin(), words.end(), names.begin(),
                 [](const auto& word) { return word.first; });
  const auto take = [&choice, words](const std::string& given) {
    for (const auto& [word, value] : words) {
      if (word == given) choice = value;
    }
  };
  return command.add_option_function<std::string>(flag, take, help)->check(one_of(names));
}

}  // namespace surefoot::command_line
