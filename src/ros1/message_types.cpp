// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// In C++17: the messages of ROS 1 use what C++20 has taken out of its library.
#include "ros1/message_types.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>
#include <vector>

namespace surefoot::ros1 {
namespace {

template <typename Message>
MessageType type_of() {
  using namespace ros::message_traits;
  return {datatype<Message>(), md5sum<Message>(), definition<Message>()};
}

}  // namespace

MessageType message_type(std::string_view name) {
  for (const MessageType& type :
       {type_of<sensor_msgs::PointCloud2>(), type_of<nav_msgs::Odometry>(),
        type_of<nav_msgs::Path>(), type_of<tf2_msgs::TFMessage>(),
        type_of<diagnostic_msgs::DiagnosticArray>()}) {
    if (type.name == name) return type;
  }
  throw std::invalid_argument(std::string(name) + " is not published for ROS 1");
}

}  // namespace surefoot::ros1
