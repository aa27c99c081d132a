// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Robots whose own software publishes scans: which topic, how often, of which mount.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/recording.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::io {

struct Robot {
  std::string name;
  std::string what;
  std::string topic;     ///< of its scans
  double rate_hz = 0.0;  ///< nominal
  Pose T_base_lidar;
};
[[nodiscard]] const std::vector<Robot>& robots();
[[nodiscard]] std::vector<std::string> robot_names();
/// Throws ReadError that lists the names.
[[nodiscard]] const Robot& robot_named(std::string_view name);

/// The robot that the options name, if what they read is its own LiDAR's: no other topic is named.
/// Nothing: none is. Throws ReadError.
[[nodiscard]] const Robot* robot_of_scans(const OpenOptions& options);

/// The options with what they leave open filled in by the robot that they name. Stamps are mended
/// at once, as on the robot itself: a recording gives what it gave there.
[[nodiscard]] OpenOptions with_robot(OpenOptions options);

}  // namespace surefoot::io
