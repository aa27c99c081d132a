// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "io/bags/bag_files.hpp"
#include "io/datasets.hpp"
#include "io/robots.hpp"
#ifdef SUREFOOT_HAS_ROS2
#include "ros2/topic_publisher.hpp"
#include "ros2/topic_subscription.hpp"
#endif

namespace surefoot::app {
namespace {

/// An Ouster's packets are not understood without what it says about itself.
std::string metadata_of(const LiveArguments& arguments) {
  std::filesystem::path file = arguments.replay;
  std::ifstream stream(file.replace_extension(".json"), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What is not kept has a name, but cannot be opened again.
void name_input(LiveArguments& arguments, const std::string& name) {
  arguments.run.is_live = arguments.record.empty();
  arguments.run.input = arguments.run.is_live ? std::filesystem::path(name) : arguments.record;
}

std::unique_ptr<live::ScanStream> packets_of(LiveArguments& arguments) {
  arguments.run.given.emplace_back("repair-stamps", "false");  // which would wait for two scans
  if (!arguments.replay.empty()) {
    return live::packet_stream(live::replay_capture(arguments.replay, arguments.speed),
                               arguments.run.reader, metadata_of(arguments), {});
  }
  name_input(arguments, fmt::format("udp-{}", arguments.udp));
  return live::packet_stream(live::listen_udp(arguments.address, arguments.udp),
                             arguments.run.reader, "", arguments.record);
}

/// The reader's options for messages; what repeats them is noted.
io::OpenOptions topic_options(LiveArguments& arguments) {
  io::OpenOptions reader = io::with_robot(io::with_dataset(arguments.run.reader));
  if (!arguments.run.reader.repair_at_once) {
    arguments.run.given.emplace_back("repair-at-once", "true");
  }
  return reader;
}

bool is_bag(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? !io::bag_files(path).empty()
                                                      : io::is_bag_file(path);
}

std::unique_ptr<live::ScanStream> replayed_messages(LiveArguments& arguments) {
  const io::OpenOptions reader = topic_options(arguments);
  return live::topic_stream(live::replay_bag(arguments.replay, reader, arguments.speed), reader,
                            {});
}

#ifdef SUREFOOT_HAS_ROS2
std::unique_ptr<live::ScanStream> messages_of(LiveArguments& arguments,
                                              std::shared_ptr<ros2::Participant> participant) {
  if (!arguments.record.empty() && arguments.record.extension() != ".mcap") {
    throw std::invalid_argument("live: messages are recorded as MCAP: --record expects FILE.mcap");
  }
  std::string name = "ros2" + arguments.ros2.topic;
  std::replace(name.begin(), name.end(), '/', '-');
  name_input(arguments, name);
  const io::OpenOptions reader = topic_options(arguments);
  const auto say = [quiet = arguments.run.quiet](const std::string& text) {
    if (!quiet) fmt::print(stderr, "note: {}\n", text);
  };
  return live::topic_stream(
      ros2::subscribe(std::move(participant), {arguments.ros2.topic, arguments.ros2.reliable, say}),
      reader, arguments.record);
}
#endif

}  // namespace

void check_source(LiveArguments& arguments) {
  bool has_topic = false;
  const bool has_packets = !arguments.replay.empty() || arguments.udp != 0;
#ifdef SUREFOOT_HAS_ROS2
  std::string& topic = arguments.ros2.topic;
  const std::string& robot = arguments.run.reader.robot;
  if (topic.empty() && !robot.empty() && !has_packets) topic = io::robot_named(robot).topic;
  has_topic = !topic.empty();
  constexpr const char* kExpected =
      "live: expected --udp PORT, --replay CAPTURE or --ros2-topic TOPIC";
#else
  constexpr const char* kExpected = "live: expected --udp PORT or --replay CAPTURE";
#endif
  if (!has_topic && !has_packets) throw std::invalid_argument(kExpected);
  if (!arguments.record.empty() && !arguments.replay.empty()) {
    throw std::invalid_argument("live: --record of what --replay plays would be the same");
  }
}

Ends ends_of(LiveArguments& arguments, [[maybe_unused]] live::CommandQueue& commands) {
  Ends ends;
#ifdef SUREFOOT_HAS_ROS2
  std::shared_ptr<ros2::Participant> participant;
  if (arguments.ros2.any()) {
    participant = std::make_shared<ros2::Participant>(arguments.ros2.participant);
  }
  if (arguments.ros2.publish) ends.messages = ros2::publish(participant);
  if (arguments.ros2.commands) {
    ends.commands = std::make_unique<ros2::CommandServer>(
        participant, std::vector<std::string>{"reset", "pause", "resume", "save_map"},
        [&](const std::string& command) { return commands.ask(command); });
  }
  ends.of_topic = !arguments.ros2.topic.empty();
  if (ends.of_topic) {
    ends.stream = messages_of(arguments, participant);
    return ends;
  }
#endif
  if (!arguments.replay.empty()) arguments.run.input = arguments.replay;
  if (is_bag(arguments.replay)) {
    ends.of_topic = true;
    ends.stream = replayed_messages(arguments);
  } else {
    ends.stream = packets_of(arguments);
  }
  return ends;
}

}  // namespace surefoot::app
