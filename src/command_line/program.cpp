// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "command_line/suggestion.hpp"
#include "process/exit_codes.hpp"
#include "process/standard_streams.hpp"
#include "text/printable.hpp"

namespace surefoot::command_line {
namespace {

/// CLI11 only says that something is missing or too much.
void check_command(const CLI::App& app, const std::vector<const char*>& words) {
  if (words.size() < 2) return;
  if (words[1][0] == '-') {
    if (app.get_option_no_throw(words[1]) != nullptr) return;
    throw std::invalid_argument(
        fmt::format("got '{}', expected a subcommand; --help shows them", words[1]));
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), words[1]) != names.end()) return;
  throw std::invalid_argument(unknown_word("subcommand", words[1], names));
}

/// The name of an option that this one begins or resembles; none: there is no such option.
std::string option_like(const std::string& written, const CLI::App& command) {
  std::vector<std::string> known;
  for (const CLI::Option* one : command.get_options()) {
    for (const std::string& name : one->get_lnames()) known.push_back(name);
  }
  const std::string name = written.substr(2, written.find('=') - 2);
  const auto longer = std::find_if(known.begin(), known.end(),
                                   [&](const std::string& one) { return one.starts_with(name); });
  return longer != known.end() ? *longer : nearest_word(name, known);
}

/// What a subcommand did not expect: its first option, if one is called nearly so, or all of it in
/// the order that it was written, which CLI11 turns round.
void check_options(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    const std::vector<std::string> left = command->remaining();
    if (left.empty()) continue;
    const auto option = std::find_if(left.begin(), left.end(), [](const std::string& word) {
      return word.starts_with("--") && word.size() > 2;
    });
    const std::string meant = option == left.end() ? "" : option_like(*option, *command);
    throw std::invalid_argument(
        meant.empty()
            ? fmt::format("{}: not expected: {}; --help shows what is", command->get_name(),
                          fmt::join(left, " "))
            : fmt::format("{}: no option is called '{}'; did you mean '--{}'? --help shows all",
                          command->get_name(), *option, meant));
  }
}

/// "PATH: why", without the name of the call that failed.
std::string text_of(const std::filesystem::filesystem_error& error) {
  return error.path1().empty()
             ? error.what()
             : error.path1().string() + ": cannot be used: " + error.code().message();
}

/// What was printed may not have arrived: the disk may be full.
void flush_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw std::system_error(errno, std::generic_category(), "what was to be printed is lost");
}

/// "surefoot help COMMAND" is "surefoot COMMAND --help", as in other programs.
std::vector<const char*> with_help_as_flag(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc < 2 || std::string_view(argv[1]) != "help") return words;
  words.erase(words.begin() + 1);
  words.push_back("--help");
  return words;
}

int parse(CLI::App& app, int argc, const char* const* argv) {
  const std::vector<const char*> words = with_help_as_flag(argc, argv);
  try {
    check_command(app, words);
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::ExtrasError& error) {
    check_options(app);
    if (app.exit(error) != 0) return process::kBadInput;
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) != 0) return process::kBadInput;
  }
  flush_output();
  return process::kDone;
}

}  // namespace

int run_program(CLI::App& app, const std::string& version, int argc, char** argv,
                const int& exit_code) {
  process::guard_standard_streams();
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  try {
    const int parsed = parse(app, argc, argv);
    return parsed != process::kDone ? parsed : exit_code;
  } catch (const std::filesystem::filesystem_error& error) {
    // Names of files and topics may hold what a terminal acts on; a list of them has lines.
    fmt::print(stderr, "surefoot: {}\n", text::printable_lines(text_of(error)));
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::broken_pipe) process::end_without_reader();
    fmt::print(stderr, "surefoot: {}\n", text::printable_lines(error.what()));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "surefoot: takes more memory than there is\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "surefoot: {}\n", text::printable_lines(error.what()));
  }
  return process::kBadInput;
}

}  // namespace surefoot::command_line
