// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "ros2/topic_network.hpp"
#include "topic_options.hpp"

namespace surefoot::app {

void add_ros2_options(CLI::App& command, live::TopicRequest& topics) {
  struct Ros2Options {
    ros2::ParticipantOptions participant;
    bool reliable = false;
  };
  const auto options = std::make_shared<Ros2Options>();
  topics.network = "ros2";
  topics.extension = ".mcap";
  topics.join = [options] { return ros2::join_domain(options->participant, options->reliable); };
  command_line::OptionGroup group(command, "ROS 2");
  constexpr int kMostDomain = 232;
  group
      .add("--ros2-topic", topics.topic,
           "a topic of scans or of a sensor's packets, instead of its packets themselves")
      ->type_name("TOPIC")
      ->excludes("--udp")
      ->excludes("--replay")
      ->excludes("--follow");
  group.add_choice<bool>(
      "--ros2-qos", options->reliable,
      "how that topic is read: best_effort gets what it gets; reliable asks again, "
      "and hears nothing of who offers best effort",
      {{"best_effort", false}, {"reliable", true}});
  group.add_flag("--ros2-publish", topics.publish,
                 "publish odometry, transforms, path, deskewed scans, local map and diagnostics");
  group.add_flag("--ros2-commands", topics.commands,
                 "do what others of the domain ask by service: /surefoot/reset, pause, resume, "
                 "save_map, localize");
  group.add("--ros2-domain", options->participant.domain, "domain of both")
      ->envname("ROS_DOMAIN_ID")
      ->check(CLI::Range(0, kMostDomain))
      ->capture_default_str();
  group
      .add("--ros2-interface", options->participant.interface,
           "network interface of both, by name or address (default: CYCLONEDDS_URI's, or "
           "the likeliest); lo: this machine alone, without multicast")
      ->type_name("NAME");
  group
      .add("--ros2-peer", options->participant.peers,
           "address to look for others at, where multicast is missing; may be repeated")
      ->allow_extra_args(false)
      ->type_name("ADDRESS");
  group.add("--ros2-node", options->participant.node, "name of the node")->capture_default_str();
}

}  // namespace surefoot::app
