// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/option_texts.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "command_line/option_checks.hpp"

namespace surefoot::command_line {

namespace {

bool is_covered(const CLI::Option& option, OptionNames except) {
  if (option.get_lnames().empty()) return false;  // an argument without a name
  return std::find(except.begin(), except.end(), option.get_lnames().front()) == except.end();
}

}  // namespace

GivenOptions given_options(const CLI::App& command, OptionNames except) {
  GivenOptions result;
  for (const CLI::Option* option : command.get_options()) {
    if (option->empty() || !is_covered(*option, except)) continue;
    std::string value = option->results().back();
    if (option->get_type_name() == kFileType) value = std::filesystem::absolute(value).string();
    result.emplace_back(option->get_lnames().front(), value);
  }
  return result;
}

std::string give_options(CLI::App& command, const GivenOptions& options, OptionNames except) {
  std::string given;
  for (const auto& [name, value] : options) {
    CLI::Option* option = command.get_option_no_throw("--" + name);
    if (option == nullptr || !is_covered(*option, except)) {
      throw std::invalid_argument(fmt::format("there is no option '{}' to restore", name));
    }
    if (!option->empty()) continue;  // the command line goes before
    try {
      option->add_result(value);
      option->run_callback();
    } catch (const CLI::Error& error) {
      throw std::invalid_argument(error.what());
    }
    given += fmt::format("{}--{}={}", given.empty() ? "" : " ", name, value);
  }
  return given;
}

}  // namespace surefoot::command_line
