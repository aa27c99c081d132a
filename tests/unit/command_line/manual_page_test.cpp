// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "command_line/manual_page.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "command_line/option_checks.hpp"

namespace surefoot::command_line {
namespace {

const ProgramNames kNames = {"walker", "Walker", "walks", "1.2"};

class ManualPage : public testing::Test {
 protected:
  ManualPage() {
    CLI::App* go = app_.add_subcommand("go", "Go somewhere");
    go->add_option("-s,--speed", speed_, ".5 or more")->capture_default_str();
    go->add_option("--gait", gait_, "How")->check(CLI::IsMember({"walk", "trot"}));
    go->add_option("where", where_, "The end");
    add_choice<bool>(*go, "--side", left_, "Where to", {{"left", true}, {"right", false}});
    go->add_option("--shoe", shoe_, "one of: boot, clog");
    app_.add_subcommand("secret", "Not shown")->group("");
  }
  CLI::App app_{"walks"};
  double speed_ = 1.0;
  bool left_ = false;
  std::string gait_, where_, shoe_;
};

TEST_F(ManualPage, TheProgramsNamesWhatItDoes) {
  const std::string page = manual_page(app_, kNames);
  EXPECT_EQ(page.rfind(".TH WALKER 1 \"\" \"walker 1.2\" \"Walker\"\n", 0), 0U) << page;
  EXPECT_NE(page.find(".BR walker\\-go (1)\nGo somewhere\n"), std::string::npos) << page;
  EXPECT_EQ(page.find("secret"), std::string::npos) << page;
}

TEST_F(ManualPage, ACommandsHasItsOptionsAndNothingThatRoffObeys) {
  const std::string page = manual_page(app_, kNames, "go");
  EXPECT_NE(page.find("[\\fIoptions\\fR] \\fIwhere\\fR\n"), std::string::npos) << page;
  EXPECT_NE(page.find(".B \\-s, \\-\\-speed \\fIFLOAT\\fR\n\\&.5 or more\n.br\nDefault: 1.\n"),
            std::string::npos)
      << page;
  EXPECT_THROW((void)manual_page(app_, kNames, "secret"), std::invalid_argument);
}

TEST_F(ManualPage, TheCompletionKnowsTheWordsOfAnOption) {
  const std::string script = bash_completion(app_, kNames);
  EXPECT_NE(script.find("\"go --gait\") words=\"walk trot \" ;;"), std::string::npos) << script;
  EXPECT_NE(script.find("\"go --side\") words=\"left right \" ;;"), std::string::npos) << script;
  EXPECT_NE(script.find("\"go --shoe\") words=\"boot clog \" ;;"), std::string::npos) << script;
  EXPECT_NE(script.find("words=\"go --help --version\""), std::string::npos) << script;
  EXPECT_NE(script.find("complete -F _walker walker\n"), std::string::npos) << script;
}

}  // namespace
}  // namespace surefoot::command_line
