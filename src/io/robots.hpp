// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Robots whose own software publishes scans: which topic, how often.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

struct Robot {
  std::string name;
  std::string what;
  std::string topic;     ///< of its scans
  double rate_hz = 0.0;  ///< nominal
};
[[nodiscard]] const std::vector<Robot>& robots();
[[nodiscard]] std::vector<std::string> robot_names();
/// Throws ReadError that lists the names.
[[nodiscard]] const Robot& robot_named(std::string_view name);

/// The options with what they leave open filled in by the robot that they name. Stamps are mended
/// at once, as on the robot itself: a recording gives what it gave there.
[[nodiscard]] OpenOptions with_robot(OpenOptions options);

}  // namespace surefoot::io
