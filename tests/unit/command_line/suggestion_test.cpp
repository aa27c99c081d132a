// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/suggestion.hpp"

#include <gtest/gtest.h>

namespace surefoot::command_line {
namespace {

const std::vector<std::string> kCommands = {"run", "info", "compare"};

TEST(Suggestion, ALetterTooManyTooFewOrWrongIsRecognised) {
  EXPECT_EQ(unknown_word("subcommand", "runn", kCommands),
            "no subcommand is called 'runn'; did you mean 'run'? there are: run, info, compare");
  EXPECT_NE(unknown_word("subcommand", "inf", kCommands).find("mean 'info'?"), std::string::npos);
  EXPECT_NE(unknown_word("subcommand", "comapre", kCommands).find("mean 'compare'?"),
            std::string::npos);
}

TEST(Suggestion, TheNearestWordOrNone) {
  const std::vector<std::string> options = {"--count", "--config"};
  EXPECT_EQ(nearest_word("--cuont", options), "--count");
  EXPECT_EQ(nearest_word("--walk", options), "");
}

TEST(Suggestion, WhatHasLittleInCommonIsNotSuggested) {
  EXPECT_EQ(unknown_word("subcommand", "walk", kCommands),
            "no subcommand is called 'walk'; there are: run, info, compare");
  EXPECT_EQ(unknown_word("subcommand", "run", {}), "no subcommand is called 'run'; there are: ");
}

}  // namespace
}  // namespace surefoot::command_line
