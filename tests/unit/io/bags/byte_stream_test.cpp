// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/byte_stream.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

std::vector<std::byte> counting(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i % 251);
  return bytes;
}

TEST(LookAheadStream, GivesTheSameBytesWhateverIsLookedAt) {
  const std::vector<std::byte> bytes = counting(10'000);
  MemoryStream whole(bytes);
  LookAheadStream stream(whole);
  std::vector<std::byte> part(55), seen(9);
  for (std::size_t at = 0; at < bytes.size(); at += part.size()) {
    for (const std::size_t offset : {at * 7 % 3000, std::size_t{0}}) {
      const std::size_t there = stream.peek(offset, seen);
      const std::size_t left = bytes.size() - std::min(bytes.size(), at + offset);
      ASSERT_EQ(there, std::min(seen.size(), left));
      for (std::size_t i = 0; i < there; ++i) ASSERT_EQ(seen[i], bytes[at + offset + i]);
    }
    const std::size_t got = stream.read(part);
    ASSERT_EQ(got, std::min(part.size(), bytes.size() - at));
    for (std::size_t i = 0; i < got; ++i) ASSERT_EQ(part[i], bytes[at + i]);
  }
  EXPECT_EQ(stream.read(part), 0U);
}

// Heads of chunks that each say that they are long: hours for a file of a few megabytes.
TEST(LookAheadStream, LookingFarAheadAgainAndAgainCostsNoMoreThanReading) {
  constexpr std::size_t kFar = 32 << 20;
  const std::vector<std::byte> bytes = counting(kFar + 4'000'000);
  MemoryStream whole(bytes);
  LookAheadStream stream(whole);
  std::vector<std::byte> part(55), seen(9);
  const std::clock_t begin = std::clock();
  for (int i = 0; i < 50'000; ++i) {
    ASSERT_EQ(stream.peek(kFar, seen), seen.size());
    ASSERT_EQ(stream.read(part), part.size());
  }
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 20.0);
}

TEST(LimitedStream, PassesOverNoMoreThanIsItsOwn) {
  const std::vector<std::byte> bytes = counting(10);
  MemoryStream whole(bytes);
  LimitedStream part(whole, 4);
  EXPECT_EQ(part.skip(9), 4U);
  std::vector<std::byte> next(2);
  EXPECT_EQ(part.read(next), 0U);
  ASSERT_EQ(whole.read(next), 2U);
  EXPECT_EQ(next[0], bytes[4]);
}

// The bytes at 0 of a process's memory, which Linux refuses.
TEST(FileStream, SaysWhyItCannotReadOn) {
  FileStream file("/proc/self/mem");
  std::vector<std::byte> bytes(9);
  try {
    (void)file.read(bytes);
    ADD_FAILURE() << "it was read";
  } catch (const ReadError& error) {
    EXPECT_STREQ(error.what(), "cannot read on after 0 bytes: Input/output error");
  }
  EXPECT_EQ(file.progress(), 1.0) << "of a file that says it is empty";
}

}  // namespace
}  // namespace surefoot::io
