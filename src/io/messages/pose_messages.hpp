// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The messages of an odometry's answers, for ROS 2 or ROS 1.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/messages/message_writer.hpp"
#include "surefoot/pose.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::io {

/// Where a frame is in another one, and how it moves.
struct OdometryMessage {
  std::int64_t stamp_ns = 0;
  std::string frame;
  std::string child_frame;
  Pose T_frame_child;
  Matrix6 covariance = Matrix6::Zero();  ///< [x y z rotX rotY rotZ], axes of `frame` [m, rad]
  Twist twist = Twist::Zero();           ///< in `child_frame` [m/s, rad/s]
};
/// nav_msgs/Odometry; the covariance of the twist is not known and zero.
[[nodiscard]] std::string format_odometry(const OdometryMessage& odometry,
                                          MessageWriter::Flavour flavour);

/// nav_msgs/Path, stamped with its last pose.
[[nodiscard]] std::string format_path(const Trajectory& poses, std::string_view frame,
                                      MessageWriter::Flavour flavour);

struct Transform {
  std::int64_t stamp_ns = 0;
  std::string parent;
  std::string child;
  Pose T_parent_child;
};
/// tf2_msgs/TFMessage.
[[nodiscard]] std::string format_transforms(const std::vector<Transform>& transforms,
                                            MessageWriter::Flavour flavour);

/// diagnostic_msgs/DiagnosticArray of one status.
struct Diagnostic {
  enum class Level : std::uint8_t { ok = 0, warn = 1, error = 2 };
  std::int64_t stamp_ns = 0;
  Level level = Level::ok;
  std::string name;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};
[[nodiscard]] std::string format_diagnostic(const Diagnostic& diagnostic,
                                            MessageWriter::Flavour flavour);

}  // namespace surefoot::io
