// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages that are copied from bag to bag as they are.
#include "io/bags/carried_messages.hpp"

#include <gtest/gtest.h>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/bags/mcap_writer.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPublishedBefore = 7;  // [ns] it was recorded

/// Ten messages from 100 ns on, and what else an MCAP file may hold.
void write_topic(const fs::path& file, const std::string& topic, std::uint64_t step_ns = 1) {
  McapWriter writer(file, {});
  const std::uint16_t channel =
      writer.add_channel(writer.add_schema("pkg/msg/Type", "ros2msg", "int32 a\n"), topic, "cdr");
  for (std::uint32_t i = 0; i < 10; ++i) {
    const std::uint64_t at = 100 + i * step_ns;
    writer.write(channel, i, at, at - kPublishedBefore, "message");
  }
  writer.attach(1, 2, "notes.txt", "text/plain", "hello");
  writer.add_metadata("about", {{"robot", "dog"}});
  writer.add_metadata("more", {{"robot", "dog"}});
  writer.finish();
}

class Carried : public testing::Test {
 protected:
  Carried() {
    fs::create_directory(folder_.path() / "in");
    write_topic(folder_.path() / "in/camera.mcap", "/camera");
    write_topic(folder_.path() / "in/imu.mcap", "/imu");
  }
  [[nodiscard]] fs::path in() const { return folder_.path() / "in"; }
  [[nodiscard]] fs::path out() const { return folder_.path() / "out.mcap"; }

  test::TemporaryFolder folder_;
};

TEST_F(Carried, EveryFileOfABagUpToTheEnd) {
  CarriedMessages others(in(), {}, {});
  const auto to = make_mcap_bag(out());
  others.copy(*to, 102, 103);
  others.copy(*to, 102, 104);
  others.copy_the_rest(*to, 102, 105);
  to->finish();
  EXPECT_EQ(others.messages(), 8U);
  EXPECT_EQ(others.topics(), 2U);
  const auto bag = open_bag(out());
  const auto messages = test::read_all_messages(*bag);
  ASSERT_EQ(messages.size(), 8U);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    EXPECT_EQ(messages[i].topic, i < 4 ? "/camera" : "/imu");
    EXPECT_EQ(messages[i].logged_ns, static_cast<std::int64_t>(102 + i % 4));
  }
}

// As this program writes what it converts from several files.
TEST_F(Carried, ATopicMayLieBehindAllOfAnotherInOneFile) {
  const auto one = make_mcap_bag(folder_.path() / "one.mcap");
  CarriedMessages(in(), {}, {}).copy_the_rest(*one, 0, 1'000);
  one->finish();
  CarriedMessages others(folder_.path() / "one.mcap", {}, {});
  const auto to = make_mcap_bag(out());
  others.copy(*to, 102, 103);
  others.copy_the_rest(*to, 102, 105);
  to->finish();
  EXPECT_EQ(others.messages(), 8U);
  EXPECT_EQ(others.topics(), 2U);
}

TEST_F(Carried, TheSearchForWhatLiesBehindIsGivenUpWhenInterrupted) {
  CarriedMessages others(in(), {}, {});
  const auto to = make_mcap_bag(out());
  others.copy_the_rest(*to, 102, 105, [] { return true; });
  to->finish();
  EXPECT_EQ(others.messages(), 4U) << "of the first file, up to the first that is too late";
}

// rosbag2 begins a new file when the last one is full: what follows is later.
TEST_F(Carried, FilesThatRosbag2WroteAreNotLookedAtBehindTheEnd) {
  constexpr std::uint64_t kStep = 10'000'000'000;
  write_topic(in() / "camera.mcap", "/camera", kStep);
  write_topic(in() / "imu.mcap", "/imu", kStep);
  folder_.write("in/metadata.yaml",
                "rosbag2_bagfile_information:\n  relative_file_paths:\n    - camera.mcap\n"
                "    - imu.mcap\n  message_count: 20\n");
  CarriedMessages others(in(), {}, {});
  const auto to = make_mcap_bag(out());
  others.copy_the_rest(*to, 0, 100 + 3 * std::int64_t{kStep});
  to->finish();
  EXPECT_EQ(others.messages(), 4U);
  EXPECT_TRUE(others.notes().empty());
}

TEST_F(Carried, MessagesKeepWhenTheyWerePublished) {
  CarriedMessages others(in(), {}, {});
  const auto to = make_mcap_bag(out());
  others.copy_the_rest(*to, 0, 1'000);
  to->finish();
  const auto bag = open_bag(out());
  std::size_t messages = 0;
  for (; const auto message = bag->next(); ++messages) {
    EXPECT_EQ(message->published_ns, message->logged_ns - std::int64_t{kPublishedBefore});
  }
  EXPECT_EQ(messages, 20U);
}

TEST_F(Carried, WhatIsNoMessageIsSaidToBeLost) {
  CarriedMessages others(in(), {}, {});
  const auto to = make_mcap_bag(out());
  others.copy_the_rest(*to, 0, 1'000);
  to->finish();
  EXPECT_EQ(others.losses(),
            (std::vector<std::string>{"lost: 2 attachments", "lost: 4 records of metadata"}));
}

}  // namespace
}  // namespace surefoot::io
