// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The message types that are written, as their definitions have them (without the comments).
#pragma once

#include <string>
#include <string_view>

namespace surefoot::io {

struct MessageDefinition {
  std::string type;       ///< "sensor_msgs/PointCloud2"
  std::string ros2_text;  ///< with every type that it refers to, as MCAP's "ros2msg" wants it
  std::string ros1_text;  ///< empty: not written for ROS 1
  std::string ros1_md5;
  /// Of a topic that is copied as it was: what ROS 2 calls its type (empty: as below), the language
  /// of ros2_text, rosbag2's YAML of what was offered, and whether who comes late gets its last.
  std::string ros2_name = {};
  std::string ros2_language = "ros2msg";
  std::string qos = {};
  bool latched = false;

  /// "sensor_msgs/msg/PointCloud2".
  [[nodiscard]] std::string ros2_type() const;
};

/// The ROS 2 text of a type that is known here, "nav_msgs/Odometry"; empty: it is not.
[[nodiscard]] std::string known_ros2_text(std::string_view type);

[[nodiscard]] MessageDefinition point_cloud2_definition();
[[nodiscard]] MessageDefinition odometry_definition();
[[nodiscard]] MessageDefinition path_definition();
[[nodiscard]] MessageDefinition transforms_definition();
[[nodiscard]] MessageDefinition diagnostics_definition();

}  // namespace surefoot::io
