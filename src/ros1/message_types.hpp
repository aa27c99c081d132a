// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace surefoot::ros1 {

/// What a listener compares before it listens.
struct MessageType {
  std::string name;  ///< "nav_msgs/Odometry"
  std::string md5;
  std::string definition;
};
/// Of those that are published. Throws std::invalid_argument for others.
[[nodiscard]] MessageType message_type(std::string_view name);

}  // namespace surefoot::ros1
