// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/manual_page.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace surefoot::command_line {

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

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (c == separator) words.push_back(std::exchange(word, ""));
    if (c != separator && c != ' ') word += c;
  }
  words.push_back(word);
  return words;
}

/// "TEXT:{pcd,ply,bin}" and "TEXT:start|end" are of these words, as is what the help says is "one
/// of: " some; "FILE", "INT:[1 - 9]" are of none.
std::vector<std::string> words_of(const CLI::Option& option) {
  constexpr std::string_view kOneOf = "one of: ";
  const std::string type = option.get_type_name(), help = option.get_description();
  const auto begin = type.find('{'), end = type.find('}');
  if (begin < end && end != std::string::npos) {
    return split(type.substr(begin + 1, end - begin - 1), ',');
  }
  if (type.find('|') != std::string::npos) return split(type.substr(type.find(':') + 1), '|');
  if (help.starts_with(kOneOf)) return split(help.substr(kOneOf.size()), ',');
  return {};
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

/// One page as it grows.
class Page {
 public:
  template <typename... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), text, std::forward<Values>(values)...);
  }
  void add_head(const ProgramNames& names, const std::string& name,
                const std::string& description) {
    std::string capitals = name;
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    add(".TH {} 1 \"\" \"{} {}\" \"{}\"\n.SH NAME\n{} \\- {}\n", roff(capitals), names.command,
        names.version, names.title, roff(name), roff(description));
  }
  void add_options(const CLI::App& command) {
    for (const std::string& group : command.get_groups()) {
      add(".SH {}\n", roff(group == "Options" ? "OPTIONS" : group));
      for (const CLI::Option* option : command.get_options()) {
        if (option->get_group() != group || !option->nonpositional()) continue;
        add(".TP\n.B {}", roff(names_of(*option)));
        if (takes_value(*option)) add(" \\fI{}\\fR", roff(option->get_type_name()));
        add("\n{}\n", roff(option->get_description()));
        if (takes_value(*option) && !option->get_default_str().empty()) {
          add(".br\nDefault: {}.\n", roff(option->get_default_str()));
        }
      }
    }
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string command_page(const CLI::App& command, const ProgramNames& names) {
  Page page;
  page.add_head(names, names.command + "-" + command.get_name(), command.get_description());
  page.add(".SH SYNOPSIS\n.B {} {}\n[\\fIoptions\\fR]", names.command, roff(command.get_name()));
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) page.add(" \\fI{}\\fR", roff(option->get_name(true)));
  }
  page.add("\n");
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() || option->get_description().empty()) continue;
    page.add(".PP\n.I {}\n\\-\n{}\n", roff(option->get_name(true)),
             roff(option->get_description()));
  }
  page.add_options(command);
  page.add(".SH SEE ALSO\n.BR {} (1)\n", names.command);
  return page.take();
}

std::string program_page(const CLI::App& app, const ProgramNames& names) {
  Page page;
  page.add_head(names, names.command, names.purpose);
  page.add(".SH SYNOPSIS\n.B {}\n\\fIcommand\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n", names.command);
  for (const CLI::App* command : listed_commands(app)) {
    page.add(".TP\n.BR {}\\-{} (1)\n{}\n", names.command, roff(command->get_name()),
             roff(command->get_description()));
  }
  page.add_options(app);
  page.add(
      ".SH EXIT STATUS\n0: done. 1: done, but something failed that the output names. 2: wrong "
      "usage, bad input, or what cannot be written. 130: ended by Ctrl\\-C or SIGTERM.\n");
  return page.take();
}

}  // namespace

std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
  std::vector<const CLI::App*> commands;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) commands.push_back(command);
  }
  return commands;
}

std::string manual_page(const CLI::App& app, const ProgramNames& names,
                        const std::string& command) {
  if (command.empty()) return program_page(app, names);
  for (const CLI::App* one : listed_commands(app)) {
    if (one->get_name() == command) return command_page(*one, names);
  }
  throw std::invalid_argument("manual: there is no command '" + command + "'");
}

std::string bash_completion(const CLI::App& app, const ProgramNames& names) {
  Page page;
  const std::string& name = names.command;
  page.add(
      "# bash completion of {0} {1}; made by `{0} manual --completion`\n"
      "_{0}() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\"\n"
      "  # bash takes --option=value for three words\n"
      "  if [[ \"$before\" == = ]]; then before=\"${{COMP_WORDS[COMP_CWORD-2]}}\"; fi\n"
      "  if [[ \"$word\" == = ]]; then word=\"\"; fi\n"
      "  local words=\"\"\n"
      "  case \"${{COMP_WORDS[1]}} $before\" in\n",
      name, names.version);
  std::string commands;
  for (const CLI::App* command : listed_commands(app)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    for (const CLI::Option* option : command->get_options()) {
      const std::vector<std::string> words = words_of(*option);
      if (words.empty() || option->get_lnames().empty()) continue;
      page.add("    \"{} --{}\") words=\"", command->get_name(), option->get_lnames().front());
      for (const std::string& one : words) page.add("{} ", one);
      page.add("\" ;;\n");
    }
  }
  page.add("    *)\n      case \"${{COMP_WORDS[1]}}\" in\n");
  for (const CLI::App* command : listed_commands(app)) {
    page.add("        {}) words=\"", command->get_name());
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& one : option->get_lnames()) page.add("--{} ", one);
    }
    page.add("\" ;;\n");
  }
  page.add(
      "      esac\n"
      "      [[ \"$word\" == -* ]] || words=\"\" ;;\n"
      "  esac\n"
      "  if [[ $COMP_CWORD == 1 ]]; then words=\"{1} --help --version\"; fi\n"
      "  if [[ -n \"$words\" ]]; then\n"
      "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "  else\n"
      "    compopt -o filenames\n"
      "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
      "  fi\n"
      "}}\n"
      "complete -F _{0} {0}\n",
      name, commands);
  return page.take();
}

}  // namespace surefoot::command_line
