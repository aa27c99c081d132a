// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot convert of bags with several topics of scans, and with messages of other types.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_writer.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kDelayNs = 30'000'000;  // from a stamp to its message's recording
constexpr int kFullScans = 4;

struct Recorded {
  std::string topic, type, definition, bytes;
  bool latched = false;
  std::int64_t logged_ns = 0;
};

std::vector<Recorded> recorded(const fs::path& bag, const std::string& topic = "") {
  std::vector<Recorded> all;
  const auto source = io::open_bag(bag);
  while (const auto message = source->next()) {
    const io::Topic& from = *message->topic;
    if (!topic.empty() && from.name != topic) continue;
    const auto* const begin = reinterpret_cast<const char*>(message->bytes.data());
    const io::TopicDefinition known = from.definition ? *from.definition : io::TopicDefinition{};
    all.push_back({from.name, from.type, known.text, std::string(begin, message->bytes.size()),
                   known.latched, message->logged_ns});
  }
  EXPECT_TRUE(source->notes().empty());
  std::stable_sort(all.begin(), all.end(), [](const Recorded& one, const Recorded& other) {
    return one.logged_ns < other.logged_ns;
  });
  return all;
}

std::vector<std::string> topics_of(const fs::path& bag) {
  std::vector<std::string> names;
  for (const Recorded& message : recorded(bag)) {
    if (std::find(names.begin(), names.end(), message.topic) == names.end()) {
      names.push_back(message.topic);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

io::MessageDefinition legs(bool ros1) {
  io::MessageDefinition definition;
  definition.type = "unitree_legged_msgs/LowState";
  (ros1 ? definition.ros1_text : definition.ros2_text) = "uint8[20] footForce\n";
  definition.ros1_md5 = "0123456789abcdef0123456789abcdef";
  return definition;
}

// Two LiDARs at 10 Hz, a robot's own message at 50 Hz, and a transform that is sent once.
void write_full_bag(io::BagWriter& bag) {
  std::vector<Scan> scans = hall_scans(kFullScans);
  for (Scan& scan : scans) scan.stamp_ns += 1'700'000'000'000'000'000;
  const bool ros1 = bag.flavour() == io::MessageWriter::Flavour::ros1;
  const std::size_t front = bag.add_topic("/front", io::point_cloud2_definition());
  const std::size_t rear = bag.add_topic("/rear", io::point_cloud2_definition());
  const std::size_t state = bag.add_topic("/state", legs(ros1));
  io::MessageDefinition transforms = io::transforms_definition();
  if (ros1) transforms = legs(true);
  transforms.latched = true;
  transforms.qos = "- history: 1\n  durability: 1\n";
  const std::size_t fixed = bag.add_topic("/fixed", transforms);
  const std::int64_t begin_ns = scans.front().stamp_ns + kDelayNs;
  bag.write(fixed, begin_ns - 50'000'000, std::string("\0\1\0\0still", 9));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::int64_t logged_ns = scans[i].stamp_ns + kDelayNs;
    for (int k = 0; k < 5; ++k) {
      const std::string bytes = std::string("\0\1\0\0", 4) + std::to_string(5 * i + k) + "\n\"x\"";
      bag.write(state, logged_ns - 40'000'000 + k * 20'000'000, bytes);
    }
    bag.write(front, logged_ns, io::format_point_cloud2(scans[i], "front", bag.flavour()));
    bag.write(rear, logged_ns + 1'000'000,
              io::format_point_cloud2(scans[i], "rear", bag.flavour()));
  }
  bag.finish();
}

// All that is no scan comes as it was, and scans with when they were recorded.
TEST(ConvertTopics, ABagIntoABagKeepsAllOfThemAndWhatElseItHolds) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_full_bag(*io::make_mcap_bag(folder / "a.mcap"));
  write_full_bag(*io::make_ros1_bag(folder / "a.bag"));
  for (const std::vector<std::string>& way :
       {std::vector<std::string>{"a.mcap", "b", "--to", "rosbag2"},
        {"b", "c.mcap"},
        {"a.bag", "b.bag"}}) {
    std::vector<std::string> arguments = {"convert"};
    arguments.insert(arguments.end(), way.begin(), way.end());
    const ProcessResult result = run_surefoot(arguments, folder);
    ASSERT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(result.errors.find("lost:"), std::string::npos) << result;
    EXPECT_EQ(result.errors.find("not read"), std::string::npos) << result;
    EXPECT_NE(result.output.find("8 scans"), std::string::npos) << result;
    EXPECT_NE(result.output.find("21 messages of 2 other topics"), std::string::npos) << result;
    const std::vector<Recorded> before = recorded(folder / way[0]);
    const std::vector<Recorded> after = recorded(folder / way[1]);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_EQ(after[i].topic, before[i].topic) << i;
      EXPECT_EQ(after[i].type, before[i].type);
      EXPECT_EQ(after[i].logged_ns, before[i].logged_ns);
      EXPECT_EQ(after[i].latched, before[i].latched);
      EXPECT_EQ(after[i].bytes, before[i].bytes);
      const bool keeps_texts = way[1] == "b.bag";
      EXPECT_EQ(after[i].definition, keeps_texts ? before[i].definition : after[i].definition);
    }
  }
  // By way of the database.
  EXPECT_NE(recorded(folder / "c.mcap", "/state").front().definition.find("footForce"),
            std::string::npos);
  EXPECT_NE(recorded(folder / "c.mcap", "/fixed").front().definition.find("transforms"),
            std::string::npos);
}

TEST(ConvertTopics, ACutKeepsOtherMessagesOfItsTimeAndWhatNeverChanges) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_full_bag(*io::make_mcap_bag(folder / "a.mcap"));
  const ProcessResult result =
      run_surefoot({"convert", "a.mcap", "b.mcap", "--begin", "0.05", "--end", "0.25"}, folder);
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(recorded(folder / "b.mcap", "/front").size(), 2U);
  EXPECT_EQ(recorded(folder / "b.mcap", "/rear").size(), 2U);
  EXPECT_EQ(recorded(folder / "b.mcap", "/fixed").size(), 1U);
  const std::vector<Recorded> states = recorded(folder / "b.mcap", "/state");
  const std::vector<Recorded> scans = recorded(folder / "b.mcap", "/front");
  ASSERT_FALSE(states.empty());
  EXPECT_GE(states.front().logged_ns, scans.front().logged_ns);
  EXPECT_LE(states.back().logged_ns, scans.back().logged_ns + 1'000'000);
  EXPECT_EQ(states.size(), 6U);
}

TEST(ConvertTopics, ThoseThatAreNamed) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_full_bag(*io::make_mcap_bag(folder / "a.mcap"));
  const auto convert = [&](std::vector<std::string> topics, const std::string& output) {
    std::vector<std::string> arguments = {"convert", "a.mcap", output};
    for (const std::string& topic : topics) {
      arguments.insert(arguments.end(), {"--topic", topic});
    }
    return run_surefoot(arguments, folder);
  };
  EXPECT_EQ(convert({"/rear"}, "one.mcap").exit_code, 0);
  EXPECT_EQ(topics_of(folder / "one.mcap"), (std::vector<std::string>{"/rear"}));
  EXPECT_EQ(convert({"/front", "/rear"}, "two.mcap").exit_code, 0);
  EXPECT_EQ(topics_of(folder / "two.mcap"), (std::vector<std::string>{"/front", "/rear"}));
  EXPECT_EQ(convert({"/rear", "/state"}, "other.mcap").exit_code, 0);
  EXPECT_EQ(topics_of(folder / "other.mcap"), (std::vector<std::string>{"/rear", "/state"}));
  EXPECT_EQ(convert({"/rear", "/rear"}, "twice.mcap").exit_code, 0);
  EXPECT_EQ(file_content(folder / "twice.mcap"), file_content(folder / "one.mcap"));
  const ProcessResult none = convert({"/rear", "/typo"}, "none.mcap");
  EXPECT_EQ(none.exit_code, 2) << none;
  EXPECT_NE(none.errors.find("no topic '/typo'"), std::string::npos) << none;
  const ProcessResult folders = convert({"/front", "/rear"}, "folder");
  EXPECT_EQ(folders.exit_code, 2) << folders;
  EXPECT_NE(folders.errors.find("surefoot convert a.mcap folder_rear --topic /rear"),
            std::string::npos)
      << folders;
}

TEST(ConvertTopics, WhatIsOfAnotherEncodingIsSaidToBeLost) {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  write_full_bag(*io::make_ros1_bag(folder / "a.bag"));
  const ProcessResult result = run_surefoot({"convert", "a.bag", "b.mcap"}, folder);
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.errors.find("lost: 20 messages of /state (unitree_legged_msgs/LowState): they "
                               "are in ROS 1's encoding"),
            std::string::npos)
      << result;
  EXPECT_EQ(topics_of(folder / "b.mcap"), (std::vector<std::string>{"/front", "/rear"}));
}

}  // namespace
}  // namespace surefoot::test
