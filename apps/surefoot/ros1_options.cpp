// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_group.hpp"
#include "ros1/topic_network.hpp"
#include "topic_options.hpp"

namespace surefoot::app {

void add_ros1_options(CLI::App& command, live::TopicRequest& topics) {
  const auto node = std::make_shared<ros1::NodeOptions>();
  topics.network = "ros1";
  topics.extension = ".bag";
  topics.join = [node] { return ros1::join_master(*node); };
  command_line::OptionGroup group(command, "ROS 1");
  group
      .add("--ros1-topic", topics.topic,
           "a topic of scans or of a sensor's packets, instead of its packets themselves")
      ->type_name("TOPIC")
      ->excludes("--udp")
      ->excludes("--replay")
      ->excludes("--follow");
  group.add_flag("--ros1-publish", topics.publish,
                 "publish odometry, transforms, path, deskewed scans, local map and diagnostics");
  group.add_flag(
      "--ros1-commands", topics.commands,
      "do what others ask by service: /surefoot/reset, pause, resume, save_map, localize");
  group.add("--ros1-master", node->master, "address of the master (default: ROS_MASTER_URI's)")
      ->type_name("URI");
  group.add("--ros1-node", node->node, "name of the node")->capture_default_str();
}

}  // namespace surefoot::app
