// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages that tell where something was, or how fast it turned.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "io/bags/message_source.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::io {

/// nav_msgs/Odometry, and what geometry_msgs has with a header and a position.
[[nodiscard]] bool is_pose_type(const std::string& type);

/// Where something was. Of a point, or by four zeros, the rotation is not known: the identity.
struct PoseMessage {
  StampedPose pose;
  bool has_rotation = true;
};

/// Of a message whose type is_pose_type(). Throws ReadError where it is not what its type asks for,
/// or holds no pose.
[[nodiscard]] PoseMessage read_pose(const Message& message);

/// What a gyroscope tells.
struct Turning {
  std::int64_t stamp_ns = 0;
  Eigen::Vector3d rate;  // [rad/s]
};

/// Of a sensor_msgs/Imu. Throws ReadError.
[[nodiscard]] Turning read_imu(const Message& message);

}  // namespace surefoot::io
