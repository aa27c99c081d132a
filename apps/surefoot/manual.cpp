// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot manual: manual pages and shell completion, made from the table of options that the
// command line itself is read by.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"

namespace surefoot::app {

namespace {

/// What roff would take for its own: backslashes, and dots or quotes at a line's beginning.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return !result.empty() && (result[0] == '.' || result[0] == '\'') ? "\\&" + result : result;
}

/// "-o, --output".
std::string names_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames()) {
    names += (names.empty() ? "--" : ", --") + name;
  }
  return names;
}

/// "TEXT:{pcd,ply,bin}" is of these words; "FILE", "INT:[1 - 9]" are of none.
std::vector<std::string> words_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.find('}');
  std::vector<std::string> words;
  if (begin == std::string::npos || end == std::string::npos || end < begin) return words;
  std::string word;
  for (const char c : type.substr(begin + 1, end - begin - 1)) {
    if (c == ',') words.push_back(std::exchange(word, ""));
    if (c != ',' && c != ' ') word += c;
  }
  words.push_back(word);
  return words;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

void print_options(const CLI::App& command) {
  for (const std::string& group : command.get_groups()) {
    fmt::print(".SH {}\n", roff(group == "Options" ? "OPTIONS" : group));
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() != group || !option->nonpositional()) continue;
      fmt::print(".TP\n.B {}", roff(names_of(*option)));
      if (takes_value(*option)) fmt::print(" \\fI{}\\fR", roff(option->get_type_name()));
      fmt::print("\n{}\n", roff(option->get_description()));
      if (takes_value(*option) && !option->get_default_str().empty()) {
        fmt::print(".br\nDefault: {}.\n", roff(option->get_default_str()));
      }
    }
  }
}

void print_head(const std::string& name, const std::string& description) {
  std::string capitals = name;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  fmt::print(".TH {} 1 \"\" \"surefoot {}\" \"Surefoot\"\n.SH NAME\n{} \\- {}\n", roff(capitals),
             SUREFOOT_VERSION, roff(name), roff(description));
}

void print_command_page(const CLI::App& command) {
  print_head("surefoot-" + command.get_name(), command.get_description());
  fmt::print(".SH SYNOPSIS\n.B surefoot {}\n[\\fIoptions\\fR]", roff(command.get_name()));
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) fmt::print(" \\fI{}\\fR", roff(option->get_name(true)));
  }
  fmt::print("\n");
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || option->get_description().empty()) continue;
    fmt::print(".PP\n.I {}\n\\-\n{}\n", roff(option->get_name(true)),
               roff(option->get_description()));
  }
  print_options(command);
  fmt::print(".SH SEE ALSO\n.BR surefoot (1)\n");
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) commands.push_back(command);
  }
  return commands;
}

void print_program_page(const CLI::App& app) {
  print_head("surefoot", "LiDAR odometry for robots that walk");
  fmt::print(".SH SYNOPSIS\n.B surefoot\n\\fIcommand\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n");
  for (const CLI::App* command : commands_of(app)) {
    fmt::print(".TP\n.BR surefoot\\-{} (1)\n{}\n", roff(command->get_name()),
               roff(command->get_description()));
  }
  print_options(app);
  fmt::print(
      ".SH EXIT STATUS\n0: done. 1: done, but something failed that the output names. 2: wrong "
      "usage, bad input, or what cannot be written. 130: ended by Ctrl\\-C or SIGTERM.\n");
}

/// Options of a command, and for those of fixed words the words; files for all else.
void print_completion(const CLI::App& app) {
  fmt::print(
      "# bash completion of surefoot {}; made by `surefoot manual --completion`\n"
      "_surefoot() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n"
      "  local words=\"\"\n"
      "  case \"${{COMP_WORDS[1]}} $before\" in\n",
      SUREFOOT_VERSION);
  std::string commands;
  for (const CLI::App* command : commands_of(app)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    for (const CLI::Option* option : command->get_options()) {
      const std::vector<std::string> words = words_of(*option);
      if (words.empty() || option->get_lnames().empty()) continue;
      fmt::print("    \"{} --{}\") words=\"", command->get_name(), option->get_lnames().front());
      for (const std::string& one : words) fmt::print("{} ", one);
      fmt::print("\" ;;\n");
    }
  }
  fmt::print("    *)\n      case \"${{COMP_WORDS[1]}}\" in\n");
  for (const CLI::App* command : commands_of(app)) {
    fmt::print("        {}) words=\"", command->get_name());
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) fmt::print("--{} ", name);
    }
    fmt::print("\" ;;\n");
  }
  fmt::print(
      "      esac\n"
      "      [[ \"$word\" == -* ]] || words=\"\" ;;\n"
      "  esac\n"
      "  if [[ $COMP_CWORD == 1 ]]; then words=\"{} --help --version\"; fi\n"
      "  if [[ -n \"$words\" ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "  else\n"
      "    compopt -o filenames\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
      "  fi\n"
      "}}\n"
      "complete -F _surefoot surefoot\n",
      commands);
}

void print_page(const CLI::App& app, const std::string& name) {
  if (name.empty()) return print_program_page(app);
  for (const CLI::App* command : commands_of(app)) {
    if (command->get_name() == name) return print_command_page(*command);
  }
  throw std::invalid_argument("manual: there is no command '" + name + "'");
}

}  // namespace

void add_manual_command(CLI::App& app, int&) {
  struct Arguments {
    std::string command;
    bool completion = false;
    bool list = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("manual", "Print a manual page, or a shell's completion");
  command->group("");  // for packages, not for users
  command->add_option("command", arguments->command, "whose page; none: the program's");
  command->add_flag("--completion", arguments->completion, "for bash");
  command->add_flag("--list", arguments->list, "the commands that have pages");
  command->callback([arguments, &app] {
    if (arguments->completion) return print_completion(app);
    if (!arguments->list) return print_page(app, arguments->command);
    for (const CLI::App* one : commands_of(app)) fmt::print("{}\n", one->get_name());
  });
}

}  // namespace surefoot::app
