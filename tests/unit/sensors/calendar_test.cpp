// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/calendar.hpp"

#include <gtest/gtest.h>

#include <array>

namespace surefoot::sensors {
namespace {

std::optional<std::int64_t> seconds_of(const std::array<unsigned char, 6>& bytes) {
  return unix_seconds(std::as_bytes(std::span(bytes)));
}

TEST(Calendar, DatesAndSecondsThatAreSentInTheirPlace) {
  EXPECT_EQ(seconds_of({124, 11, 27, 18, 55, 27}), 1732733727);
  EXPECT_EQ(seconds_of({0, 0, 0x65, 0, 0, 1}), 0x65000001);
}

// Drivers of one sensor expect either, and a third that adds two hundred.
TEST(Calendar, YearsCountFrom1900OrFrom2000) {
  for (const int year : {24, 124, 224}) {
    EXPECT_EQ(seconds_of({static_cast<unsigned char>(year), 11, 27, 18, 55, 27}), 1732733727)
        << year;
  }
  EXPECT_EQ(seconds_of({70, 1, 1, 0, 0, 5}), 5) << "of a clock that nobody has set";
}

// What fuzzing found: such seconds are no number of nanoseconds.
TEST(Calendar, SecondsBeyondTheCenturyAreNone) {
  EXPECT_FALSE(seconds_of({0, 123, 1, 2, 3, 4}));
  EXPECT_FALSE(seconds_of({0, 255, 255, 255, 255, 255}));
  EXPECT_FALSE(seconds_of({1, 13, 40, 0, 0, 0}));
}

}  // namespace
}  // namespace surefoot::sensors
