// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The message types that are written, as their definitions have them (without the comments).
#pragma once

#include <string>

namespace surefoot::io {

struct MessageDefinition {
  std::string type;       ///< "sensor_msgs/PointCloud2"
  std::string ros2_text;  ///< with every type that it refers to, as MCAP's "ros2msg" wants it
  std::string ros1_text;  ///< empty: not written for ROS 1
  std::string ros1_md5;

  /// "sensor_msgs/msg/PointCloud2".
  [[nodiscard]] std::string ros2_type() const;
};

[[nodiscard]] MessageDefinition point_cloud2_definition();
[[nodiscard]] MessageDefinition odometry_definition();
[[nodiscard]] MessageDefinition path_definition();
[[nodiscard]] MessageDefinition transforms_definition();
[[nodiscard]] MessageDefinition diagnostics_definition();

}  // namespace surefoot::io
