// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/capture_file.hpp"

#include <gtest/gtest.h>

#include "io/bags/compression.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

TEST(CaptureFile, StampsMayLieBefore1970ButNotAnywhere) {
  const test::TemporaryFolder folder;
  constexpr std::int64_t kFarthest = 4'500'000'000;
  const auto capture = [&](std::int64_t begin_s) {
    test::PcapngFile file(1, 9, false, begin_s);
    file.add(250'000'000, "frame");
    return CaptureFile(folder.write("a.pcapng", file.content()));
  };
  for (const std::int64_t begin_s : {-kFarthest, std::int64_t{-1}, kFarthest}) {
    const auto frame = capture(begin_s).next();
    ASSERT_TRUE(frame) << begin_s;
    EXPECT_EQ(frame->stamp_ns, begin_s * 1'000'000'000 + 250'000'000);
  }
  for (const std::int64_t begin_s : {-kFarthest - 1, kFarthest + 1}) {
    CaptureFile file = capture(begin_s);
    EXPECT_FALSE(file.next());
    EXPECT_EQ(file.cut_short(), "a packet is stamped " + std::to_string(begin_s) +
                                    " s after 1970; expected at most 4500000000 s before or after");
  }
}

TEST(CaptureFile, TellsHowFarItIsRead) {
  const test::TemporaryFolder folder;
  test::PcapFile capture;
  for (std::uint32_t i = 0; i < 20'000; ++i) capture.add(i, test::little(0x9e3779b9U * i));
  const std::string plain = capture.content();
  for (const std::string& bytes : {plain, compress(Compression::zstd, plain)}) {
    CaptureFile file(folder.write("a.pcap", bytes));
    for (int i = 0; i < 4'000; ++i) ASSERT_TRUE(file.next());
    EXPECT_GT(file.progress(), 0.1);
    EXPECT_LT(file.progress(), 0.9);
    while (file.next()) {
    }
    EXPECT_EQ(file.progress(), 1.0);
    EXPECT_EQ(file.cut_short(), "");
  }
}

}  // namespace
}  // namespace surefoot::io
