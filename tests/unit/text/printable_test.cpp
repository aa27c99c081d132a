// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "text/printable.hpp"

#include <gtest/gtest.h>

namespace surefoot::text {
namespace {

TEST(Printable, NothingThatATerminalObeys) {
  EXPECT_EQ(printable("a\nb\x1b[31m\x7f"), "a?b?[31m?");
  EXPECT_EQ(printable("a\xC2\x9B"
                      "31m\xC2\x80"),
            "a?31m?");
  EXPECT_EQ(printable("\xC2\xA0 H\xC3\xBCtte \xE2\x82\xAC \xF0\x9F\xA6\xBF"),
            "\xC2\xA0 H\xC3\xBCtte \xE2\x82\xAC \xF0\x9F\xA6\xBF");
}

TEST(Printable, WhatIsNoUtf8) {
  EXPECT_EQ(printable("H\xFCtte \x9B"
                      "1m"),
            "H?tte ?1m");
  EXPECT_EQ(printable("cut \xE2\x82"), "cut ??");
  EXPECT_EQ(printable("\xC0\x9B"), "??") << "a control character in more bytes than it takes";
  EXPECT_EQ(shell_word("a \xFC"), "'a ?'");
}

TEST(Printable, LinesOfAText) {
  EXPECT_EQ(printable_lines("topics:\n  a\x1b\n  H\xFC\n\nb"), "topics:\n  a?\n  H?\n\nb");
  EXPECT_EQ(printable_lines("one\n"), "one\n");
  EXPECT_EQ(printable_lines(""), "");
}

TEST(ShellWord, IsOneWordWhateverItHolds) {
  EXPECT_EQ(shell_word("/a/b_1.bag"), "/a/b_1.bag");
  EXPECT_EQ(shell_word("my bag"), "'my bag'");
  EXPECT_EQ(shell_word("/x$(touch y)`z`"), "'/x$(touch y)`z`'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word("a\x1b\n"), "'a?\?'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace surefoot::text
