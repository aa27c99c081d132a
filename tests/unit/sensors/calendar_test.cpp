// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/calendar.hpp"

#include <gtest/gtest.h>

#include <array>

namespace surefoot::sensors {
namespace {

std::optional<std::int64_t> seconds_of(const std::array<unsigned char, 6>& bytes) {
  return unix_seconds(std::as_bytes(std::span(bytes)), 1900);
}

TEST(Calendar, DatesAndSecondsThatAreSentInTheirPlace) {
  EXPECT_EQ(seconds_of({124, 11, 27, 18, 55, 27}), 1732733727);
  EXPECT_EQ(seconds_of({0, 0, 0x65, 0, 0, 1}), 0x65000001);
}

// What fuzzing found: such seconds are no number of nanoseconds.
TEST(Calendar, SecondsBeyondTheCenturyAreNone) {
  EXPECT_FALSE(seconds_of({0, 123, 1, 2, 3, 4}));
  EXPECT_FALSE(seconds_of({0, 255, 255, 255, 255, 255}));
  EXPECT_FALSE(seconds_of({1, 13, 40, 0, 0, 0}));
}

}  // namespace
}  // namespace surefoot::sensors
