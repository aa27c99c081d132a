// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// This program as a node of ROS 1.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ros {
class NodeHandle;
}

namespace surefoot::ros1 {

struct NodeOptions {
  std::string node = "surefoot";
  std::string master;  ///< its address; empty: ROS_MASTER_URI's
};

/// There can be one in a process. Signals are left to the program.
class Node {
 public:
  /// Throws std::runtime_error where no master answers.
  explicit Node(const NodeOptions& options);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  [[nodiscard]] ros::NodeHandle& handle() const { return *handle_; }
  /// Topics that somebody publishes, and their types.
  [[nodiscard]] static std::vector<std::pair<std::string, std::string>> topics();

 private:
  std::unique_ptr<ros::NodeHandle> handle_;
};

}  // namespace surefoot::ros1
