// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/printable.hpp"

#include <gtest/gtest.h>

namespace surefoot::io {
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

}  // namespace
}  // namespace surefoot::io
