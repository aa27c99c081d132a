// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2_options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"

namespace surefoot::app {

void add_ros2_options(CLI::App& command, Ros2Arguments& arguments) {
  command_line::OptionGroup group(command, "ROS 2");
  constexpr int kMostDomain = 232;
  group
      .add("--ros2-topic", arguments.topic,
           "a topic of scans or of a sensor's packets, instead of its packets themselves")
      ->type_name("TOPIC")
      ->excludes("--udp")
      ->excludes("--replay");
  group.add_choice<bool>(
      "--ros2-qos", arguments.reliable,
      "how that topic is read: best_effort gets what it gets; reliable asks again, "
      "and hears nothing of who offers best effort",
      {{"best_effort", false}, {"reliable", true}});
  group.add_flag("--ros2-publish", arguments.publish,
                 "publish odometry, transforms, path, deskewed scans, local map and diagnostics");
  group.add_flag("--ros2-commands", arguments.commands,
                 "do what others of the domain ask by service: /surefoot/reset, pause, resume, "
                 "save_map, localize");
  group.add("--ros2-domain", arguments.participant.domain, "domain of both")
      ->envname("ROS_DOMAIN_ID")
      ->check(CLI::Range(0, kMostDomain))
      ->capture_default_str();
  group
      .add("--ros2-interface", arguments.participant.interface,
           "network interface of both, by name or address (default: CYCLONEDDS_URI's, or "
           "the likeliest); lo: this machine alone, without multicast")
      ->type_name("NAME");
  group
      .add("--ros2-peer", arguments.participant.peers,
           "address to look for others at, where multicast is missing; may be repeated")
      ->allow_extra_args(false)
      ->type_name("ADDRESS");
  group.add("--ros2-node", arguments.participant.node, "name of the node")->capture_default_str();
}

}  // namespace surefoot::app
