// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

#include "io/bags/bag_files.hpp"
#include "io/datasets.hpp"
#include "io/printable.hpp"
#include "io/robots.hpp"
#ifdef SUREFOOT_HAS_ROS1
#include "ros1/topic_publisher.hpp"
#include "ros1/topic_subscription.hpp"
#endif
#ifdef SUREFOOT_HAS_ROS2
#include "ros2/topic_publisher.hpp"
#include "ros2/topic_subscription.hpp"
#endif

namespace surefoot::app {
namespace {

const std::vector<std::string> kCommands = {"reset", "pause", "resume", "save_map", "localize"};

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

#if defined(SUREFOOT_HAS_ROS1) || defined(SUREFOOT_HAS_ROS2)
/// A topic named by which ROS it is of, and recorded as that ROS has it.
io::OpenOptions prepare_topic(LiveArguments& arguments, std::string name,
                              const std::string& extension) {
  if (!arguments.record.empty() && arguments.record.extension() != extension) {
    throw std::invalid_argument(fmt::format("live: --record of a topic expects FILE{}", extension));
  }
  std::replace(name.begin(), name.end(), '/', '-');
  name_input(arguments, name);
  return topic_options(arguments);
}

std::function<void(const std::string&)> notes_of(const LiveArguments& arguments) {
  return [quiet = arguments.run.quiet](const std::string& text) {
    if (!quiet) fmt::print(stderr, "note: {}\n", io::printable(text));
  };
}
#endif

#ifdef SUREFOOT_HAS_ROS1
std::unique_ptr<live::ScanStream> open_ros1(LiveArguments& arguments, Ends& ends,
                                            live::CommandQueue& commands) {
  if (!arguments.ros1.any()) return nullptr;
  const auto node = std::make_shared<ros1::Node>(arguments.ros1.node);
  if (arguments.ros1.publish) ends.messages = ros1::publish(node);
  if (arguments.ros1.commands) {
    ends.ros1_commands = std::make_unique<ros1::TriggerServices>(
        node, kCommands, [&](const std::string& command) { return commands.ask(command); });
  }
  if (arguments.ros1.topic.empty()) return nullptr;
  const io::OpenOptions reader = prepare_topic(arguments, "ros1" + arguments.ros1.topic, ".bag");
  return live::topic_stream(ros1::subscribe(node, arguments.ros1.topic, notes_of(arguments)),
                            reader, arguments.record);
}
#endif

#ifdef SUREFOOT_HAS_ROS2
std::unique_ptr<live::ScanStream> open_ros2(LiveArguments& arguments, Ends& ends,
                                            live::CommandQueue& commands) {
  if (!arguments.ros2.any()) return nullptr;
  const auto participant = std::make_shared<ros2::Participant>(arguments.ros2.participant);
  if (arguments.ros2.publish) ends.messages = ros2::publish(participant);
  if (arguments.ros2.commands) {
    ends.commands = std::make_unique<ros2::CommandServer>(
        participant, kCommands, [&](const std::string& command) { return commands.ask(command); });
  }
  if (arguments.ros2.topic.empty()) return nullptr;
  const io::OpenOptions reader = prepare_topic(arguments, "ros2" + arguments.ros2.topic, ".mcap");
  return live::topic_stream(
      ros2::subscribe(participant,
                      {arguments.ros2.topic, arguments.ros2.reliable, notes_of(arguments)}),
      reader, arguments.record);
}
#endif

}  // namespace

void check_source(LiveArguments& arguments) {
  bool has_topic = false;
  const bool has_packets = !arguments.replay.empty() || arguments.udp != 0;
#if defined(SUREFOOT_HAS_ROS1)
  has_topic = !arguments.ros1.topic.empty();
  constexpr const char* kExpected =
      "live: expected --udp PORT, --replay CAPTURE or --ros1-topic TOPIC";
#elif defined(SUREFOOT_HAS_ROS2)
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
#ifdef SUREFOOT_HAS_ROS1
  ends.stream = open_ros1(arguments, ends, commands);
#endif
#ifdef SUREFOOT_HAS_ROS2
  ends.stream = open_ros2(arguments, ends, commands);
#endif
  ends.of_topic = ends.stream != nullptr;
  if (ends.of_topic) return ends;
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
