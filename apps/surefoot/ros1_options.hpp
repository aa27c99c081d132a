// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "ros1/node.hpp"

namespace CLI {
class App;
}

namespace surefoot::app {

struct Ros1Arguments {
  ros1::NodeOptions node;
  std::string topic;
  bool publish = false;
  bool commands = false;

  [[nodiscard]] bool any() const { return !topic.empty() || publish || commands; }
};

void add_ros1_options(CLI::App& command, Ros1Arguments& arguments);

}  // namespace surefoot::app
