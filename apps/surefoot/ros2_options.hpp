// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "io/bags/bag_writer.hpp"
#include "live/topic_source.hpp"
#include "ros2/participant.hpp"

namespace CLI {
class App;
}

namespace surefoot::app {

struct Ros2Arguments {
  ros2::ParticipantOptions participant;
  std::string topic;
  bool reliable = false;
  bool publish = false;
  bool commands = false;

  [[nodiscard]] bool any() const { return !topic.empty() || publish || commands; }
};

/// The domain is ROS_DOMAIN_ID's where none is given.
void add_ros2_options(CLI::App& command, Ros2Arguments& arguments);

}  // namespace surefoot::app
