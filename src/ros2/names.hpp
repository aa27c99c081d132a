// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How ROS 2 names things on the wire (REP 2011 has the hashes; design.ros2.org, "Topic and Service
// name mapping to DDS").
#pragma once

#include <string>
#include <string_view>

namespace surefoot::ros2 {

/// "sensor_msgs::msg::dds_::PointCloud2_" of "sensor_msgs/PointCloud2".
[[nodiscard]] std::string wire_type(std::string_view type);
/// "rt/points" of "/points" or "points".
[[nodiscard]] std::string wire_topic(std::string_view topic);
/// Whether ROS 2 lets a node have that name: "surefoot", "robot_1".
[[nodiscard]] bool is_node_name(std::string_view node);
/// "/points" of "rt/points"; empty for what is no topic: a service's, or DDS's own.
[[nodiscard]] std::string topic_of(std::string_view wire_name);

/// A topic as DDS knows it.
struct WireTopic {
  std::string name;
  std::string type;
  std::string user_data;  ///< that endpoints tell of themselves
};
[[nodiscard]] WireTopic message_topic(std::string_view topic, std::string_view type);
/// Those of a service "/surefoot/reset" of std_srvs/srv/Trigger.
[[nodiscard]] WireTopic trigger_request_topic(std::string_view service);
[[nodiscard]] WireTopic trigger_reply_topic(std::string_view service);

/// "typehash=RIHS01_...;", which endpoints of Iron and later tell each other; empty where the
/// type's is not known.
[[nodiscard]] std::string type_hash_data(std::string_view type);

}  // namespace surefoot::ros2
