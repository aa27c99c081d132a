// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros1_options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/option_group.hpp"

namespace surefoot::app {

void add_ros1_options(CLI::App& command, Ros1Arguments& arguments) {
  command_line::OptionGroup group(command, "ROS 1");
  group
      .add("--ros1-topic", arguments.topic,
           "a topic of scans or of a sensor's packets, instead of its packets themselves")
      ->type_name("TOPIC")
      ->excludes("--udp")
      ->excludes("--replay");
  group.add_flag("--ros1-publish", arguments.publish,
                 "publish odometry, transforms, path, deskewed scans, local map and diagnostics");
  group.add_flag(
      "--ros1-commands", arguments.commands,
      "do what others ask by service: /surefoot/reset, pause, resume, save_map, localize");
  group
      .add("--ros1-master", arguments.node.master,
           "address of the master (default: ROS_MASTER_URI's)")
      ->type_name("URI");
  group.add("--ros1-node", arguments.node.node, "name of the node")->capture_default_str();
}

}  // namespace surefoot::app
