// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "live/datagram_source.hpp"

namespace surefoot::live {
namespace {

// Else all that waited would have come an hour ago, and who ends a run by --silence would.
TEST(UdpSource, AClockThatIsSetMakesNoPacketOldOrNew) {
  constexpr std::int64_t kNow = 1'700'000'000'000'000'000, kMs = 1'000'000, kHour = 3'600'000 * kMs;
  EXPECT_EQ(waited(kNow - 3 * kMs, kNow), std::chrono::milliseconds(3));
  EXPECT_EQ(waited(kNow - kHour, kNow), std::chrono::seconds(1));
  EXPECT_EQ(waited(kNow + kHour, kNow), std::chrono::seconds(0));
}

}  // namespace
}  // namespace surefoot::live
