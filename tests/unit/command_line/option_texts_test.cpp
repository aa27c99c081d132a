// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/option_texts.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "command_line/option_checks.hpp"

namespace surefoot::command_line {
namespace {

constexpr std::array kExcept = {"help", "quiet"};

struct Command {
  Command() {
    app.add_option("input", input);
    app.add_option("--rate", rate)->check(number_within(1.0, 100.0));
    app.add_option("--stamps", stamps)->type_name(kFileType);
    app.add_flag("--repair,!--no-repair", repair);
    app.add_flag("--quiet", quiet);
  }
  CLI::App app;
  std::string input, stamps;
  double rate = 10.0;
  bool repair = true, quiet = false;
};

TEST(OptionTexts, WhatIsGivenGivesTheSameAgain) {
  Command first;
  first.app.parse("in --rate 20 --stamps times.txt --no-repair --quiet");
  const GivenOptions given = given_options(first.app, kExcept);
  ASSERT_EQ(given.size(), 3U);
  EXPECT_EQ(given[0], GivenOptions::value_type("rate", "20"));
  EXPECT_EQ(given[1].second, std::filesystem::absolute("times.txt").string());
  Command again;
  again.app.parse("");
  EXPECT_EQ(give_options(again.app, given, kExcept).rfind("--rate=20 --stamps=/", 0), 0U);
  EXPECT_EQ(again.rate, 20.0);
  EXPECT_EQ(again.stamps, given[1].second);
  EXPECT_FALSE(again.repair);
  EXPECT_FALSE(again.quiet);
}

TEST(OptionTexts, TheCommandLineGoesBefore) {
  Command command;
  command.app.parse("--rate 30");
  EXPECT_EQ(give_options(command.app, {{"rate", "20"}}, kExcept), "");
  EXPECT_EQ(command.rate, 30.0);
}

TEST(OptionTexts, WhatThereIsNotOrIsRefusedIsSaid) {
  Command command;
  command.app.parse("");
  EXPECT_THROW((void)give_options(command.app, {{"wind", "1"}}, kExcept), std::invalid_argument);
  EXPECT_THROW((void)give_options(command.app, {{"quiet", "true"}}, kExcept),
               std::invalid_argument);
  EXPECT_THROW((void)give_options(command.app, {{"rate", "0"}}, kExcept), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::command_line
