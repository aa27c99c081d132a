// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Files and pipes that grow while they are read.
#include "live/followed_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "io/recording.hpp"
#include "support/scratch.hpp"

namespace surefoot::live {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

void append(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::app) << text;
}

std::string read(FollowedFile& file, std::size_t count) {
  std::string text(count, '\0');
  text.resize(file.read(std::as_writable_bytes(std::span(text))));
  return text;
}

class FollowedFileTest : public test::Scratch {
 protected:
  fs::path file_ = folder_ / "growing";
  std::atomic<int> asked_ = 0;
  std::atomic<int> patience_ = 1'000'000;
  [[nodiscard]] std::function<bool()> goes_on() {
    return [this] { return ++asked_ <= patience_; };
  }
};

TEST_F(FollowedFileTest, WhatIsThereIsGivenAndWhatComesIsWaitedFor) {
  append(file_, "abc");
  FollowedFile followed(file_, goes_on());
  EXPECT_EQ(read(followed, 2), "ab");
  EXPECT_EQ(asked_, 0);
  std::thread writer([this] {
    for (const char* part : {"d", "ef", "ghij"}) {
      while (asked_ == 0) std::this_thread::sleep_for(milliseconds(1));
      append(file_, part);
      asked_ = 0;
    }
  });
  EXPECT_EQ(read(followed, 6), "cdefgh");  // however it came
  writer.join();
  EXPECT_EQ(read(followed, 2), "ij");
}

TEST_F(FollowedFileTest, ItEndsWhereNobodyWantsToWait) {
  append(file_, "abc");
  patience_ = 3;
  FollowedFile followed(file_, goes_on());
  EXPECT_EQ(read(followed, 5), "abc");
  EXPECT_EQ(asked_, 4);
}

TEST_F(FollowedFileTest, AFileThatBecameShorterIsToldOf) {
  append(file_, "abcdef");
  FollowedFile followed(file_, goes_on());
  EXPECT_EQ(read(followed, 6), "abcdef");
  fs::resize_file(file_, 2);
  try {
    (void)read(followed, 1);
    FAIL();
  } catch (const io::ReadError& error) {
    EXPECT_STREQ(error.what(), "it has become shorter, 2 bytes, of which 6 were read");
  }
}

std::string long_text() {
  std::string text;
  for (int i = 0; text.size() < (12U << 20); ++i) text += std::to_string(i) + ' ';
  return text;
}

/// How often this thread has asked the system to read.
std::uint64_t calls_of_read() {
  std::ifstream counts("/proc/thread-self/io");
  std::uint64_t calls = 0;
  for (std::string name; counts >> name >> calls && name != "syscr:";) {
  }
  return calls;
}

TEST_F(FollowedFileTest, ALongFileIsReadInLargePiecesHoweverFewBytesAreAskedFor) {
  const std::string text = long_text();
  append(file_, text);
  FollowedFile followed(file_, goes_on());
  const std::uint64_t before = calls_of_read();
  if (before == 0) GTEST_SKIP() << "the kernel does not count calls here";
  for (std::size_t at = 0; at < (4U << 20); at += 16) {
    ASSERT_EQ(read(followed, 16), text.substr(at, 16));
  }
  const std::uint64_t calls = calls_of_read() - before;
  EXPECT_LT(calls, 100U);  // and 262,144 one by one
  patience_ = 0;
  EXPECT_EQ(read(followed, text.size()), text.substr(4U << 20));
}

TEST_F(FollowedFileTest, WhatIsWrittenAgainNearTheEndIsReadAsItIsThen) {
  append(file_, std::string(1000, 'a'));
  FollowedFile followed(file_, goes_on(), 8U << 20);
  EXPECT_EQ(read(followed, 10), std::string(10, 'a'));
  std::fstream(file_, std::ios::binary | std::ios::in | std::ios::out).seekp(500).write("b", 1);
  EXPECT_EQ(read(followed, 490), std::string(490, 'a'));
  EXPECT_EQ(read(followed, 2), "ba");
}

TEST_F(FollowedFileTest, APipeEndsWhereItsWriterHasClosedItAndNotBeforeOneCame) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  FollowedFile followed(file_, goes_on());  // does not wait for who writes
  std::thread writer([this] {
    while (asked_ < 3) std::this_thread::sleep_for(milliseconds(1));
    std::ofstream pipe(file_, std::ios::binary);
    pipe << "abc" << std::flush;
    std::this_thread::sleep_for(milliseconds(80));
    pipe << "def";
  });
  EXPECT_EQ(read(followed, 10), "abcdef");
  writer.join();
}

TEST_F(FollowedFileTest, WhatCannotGrowIsRefused) {
  const auto refused = [this](const fs::path& what, const std::string& why) {
    try {
      FollowedFile followed(what, goes_on());
      FAIL() << what;
    } catch (const io::ReadError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused(file_, "No such file");
  refused(file_.parent_path(), "expected a file or a pipe");
  refused("/dev/null", "expected a file or a pipe");
}

}  // namespace
}  // namespace surefoot::live
