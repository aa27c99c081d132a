// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <utility>
#include <vector>

#include "command_line/option_checks.hpp"

namespace surefoot::command_line {

/// The options of a command that its help shows under one heading.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string heading)
      : command_(command), heading_(std::move(heading)) {}

  /// As CLI::App::add_option: `variable` must live until the command line is parsed.
  template <typename Variable>
  CLI::Option* add(const std::string& flag, Variable& variable, const std::string& help) {
    return command_.add_option(flag, variable, help)->group(heading_);
  }
  CLI::Option* add_flag(const std::string& flag, bool& variable, const std::string& help) {
    return command_.add_flag(flag, variable, help)->group(heading_);
  }
  template <typename Choice>
  CLI::Option* add_choice(const std::string& flag, Choice& choice, const std::string& help,
                          const std::vector<std::pair<std::string, Choice>>& words) {
    return command_line::add_choice(command_, flag, choice, help, words)->group(heading_);
  }

 private:
  CLI::App& command_;
  std::string heading_;
};

}  // namespace surefoot::command_line
