// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/option_checks.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "command_line/option_group.hpp"

namespace surefoot::command_line {
namespace {

bool is_taken(const CLI::Validator& check, std::string text) { return check(text).empty(); }

TEST(OptionChecks, WholeNumbersHaveNoSignNoFractionAndNoEnd) {
  for (const char* good : {"1", "42", "18446744073709551615"}) {
    EXPECT_TRUE(is_taken(whole_number(1), good)) << good;
  }
  for (const char* bad : {"0", "-1", "1.5", "1e3", "", " 1", "1 ", "18446744073709551616", "x"}) {
    EXPECT_FALSE(is_taken(whole_number(1), bad)) << bad;
  }
}

TEST(OptionChecks, NumbersAreWithinBothEndsAndAreNumbers) {
  for (const char* good : {"-0.5", "0", "1e-3", "2"}) {
    EXPECT_TRUE(is_taken(number_within(-0.5, 2.0), good)) << good;
  }
  for (const char* bad : {"-0.51", "2.0001", "nan", "inf", "", "1m"}) {
    EXPECT_FALSE(is_taken(number_within(-0.5, 2.0), bad)) << bad;
  }
}

TEST(OptionChecks, AChoiceIsMadeByItsWordUnderItsHeading) {
  CLI::App app;
  int choice = 0;
  OptionGroup(app, "Reading").add_choice<int>("--pick", choice, "help", {{"one", 1}, {"two", 2}});
  EXPECT_EQ(app.get_option("--pick")->get_group(), "Reading");
  app.parse("--pick two");
  EXPECT_EQ(choice, 2);
  EXPECT_THROW(app.parse("--pick three"), CLI::ValidationError);
}

}  // namespace
}  // namespace surefoot::command_line
