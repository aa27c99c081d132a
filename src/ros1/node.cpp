// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros1/node.hpp"

#include <ros/ros.h>

#include <stdexcept>

namespace surefoot::ros1 {

Node::Node(const NodeOptions& options) {
  ros::M_string remappings;
  if (!options.master.empty()) remappings["__master"] = options.master;
  try {
    ros::init(remappings, options.node, ros::init_options::NoSigintHandler);
  } catch (const ros::Exception& error) {
    throw std::runtime_error(std::string("ROS 1: ") + error.what());
  }
  if (!ros::master::check()) {  // else whatever comes next waits for it
    throw std::runtime_error("ROS 1: no master answers at " + ros::master::getURI() +
                             "; start roscore, or --ros1-master");
  }
  handle_ = std::make_unique<ros::NodeHandle>();
}

Node::~Node() {
  handle_.reset();
  ros::shutdown();
}

std::vector<std::pair<std::string, std::string>> Node::topics() {
  ros::master::V_TopicInfo seen;
  (void)ros::master::getTopics(seen);
  std::vector<std::pair<std::string, std::string>> topics;
  for (const ros::master::TopicInfo& topic : seen) topics.emplace_back(topic.name, topic.datatype);
  return topics;
}

}  // namespace surefoot::ros1
