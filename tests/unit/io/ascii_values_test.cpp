// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/ascii_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace surefoot::io {
namespace {

TEST(AsciiValues, ANumberHasOneSign) {
  double value = 0.0;
  EXPECT_TRUE(parse_real("+1.5", value));
  EXPECT_EQ(value, 1.5);
  EXPECT_TRUE(parse_real("-1.5", value));
  EXPECT_EQ(value, -1.5);
  std::size_t count = 0;
  EXPECT_TRUE(parse_count("+7", count));
  EXPECT_EQ(count, 7U);
  for (const char* bad : {"+-1", "++1", "-+1", "--1", "+", "-", ""}) {
    EXPECT_FALSE(parse_real(bad, value)) << bad;
    EXPECT_FALSE(parse_count(bad, count)) << bad;
  }
}

TEST(AsciiValues, ANumberIsAWholeWordAndFitsItsType) {
  double value = 0.0;
  for (const char* bad : {"1x", "1 ", " 1", "1e400"}) EXPECT_FALSE(parse_real(bad, value)) << bad;
  std::byte out{};
  EXPECT_TRUE(store_number("255", ScalarType::u8, &out));
  EXPECT_EQ(out, std::byte{255});
  EXPECT_TRUE(store_number("3.0", ScalarType::u8, &out)) << "as who writes all columns alike";
  EXPECT_EQ(out, std::byte{3});
  for (const char* bad : {"256", "-1", "1.5", "256.0", "-1.0", "nan", "1e300"}) {
    EXPECT_FALSE(store_number(bad, ScalarType::u8, &out)) << bad;
  }
  std::int64_t wide = 0;
  EXPECT_TRUE(store_number("-5e9", ScalarType::i64, reinterpret_cast<std::byte*>(&wide)));
  EXPECT_EQ(wide, -5'000'000'000);
  EXPECT_FALSE(store_number("1e19", ScalarType::i64, reinterpret_cast<std::byte*>(&wide)));
  // Written with more range than a float has.
  float narrow = 0.0F;
  EXPECT_TRUE(store_number("1e50", ScalarType::f32, reinterpret_cast<std::byte*>(&narrow)));
  EXPECT_TRUE(std::isinf(narrow));
  for (const char* none : {"nan", "-1.#IND", "1.#QNAN"}) {
    narrow = 0.0F;
    EXPECT_TRUE(store_number(none, ScalarType::f32, reinterpret_cast<std::byte*>(&narrow)));
    EXPECT_TRUE(std::isnan(narrow)) << none;
  }
}

TEST(AsciiValues, WhatIsShownOfAWordIsPrintableAndShort) {
  EXPECT_EQ(in_quotes("a b~"), "'a b~'");
  EXPECT_EQ(in_quotes("\x1b\x7f\xe4"), "'\\x1b\\x7f\\xe4'");
  EXPECT_EQ(in_quotes(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(in_quotes(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(AsciiValues, DigitsAloneAreWhole) {
  EXPECT_TRUE(is_whole("0123"));
  for (const char* bad : {"", "+1", "1.", "1e3"}) EXPECT_FALSE(is_whole(bad)) << bad;
}

}  // namespace
}  // namespace surefoot::io
