// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/robots.hpp"

namespace surefoot::io {

const std::vector<Robot>& robots() {
  // The mount: radar_joint of the Go2's URDF.
  static const std::vector<Robot> all = {
      {"go2",
       "Unitree Go2, its own L1",
       "/utlidar/cloud",
       1.0 / 0.130,
       {from_roll_pitch_yaw({0.0, 2.8782, 0.0}), {0.28945, 0.0, -0.046825}}}};
  return all;
}

std::vector<std::string> robot_names() {
  std::vector<std::string> names;
  for (const Robot& robot : robots()) names.push_back(robot.name);
  return names;
}

const Robot& robot_named(std::string_view name) {
  std::string names;
  for (const Robot& robot : robots()) {
    if (robot.name == name) return robot;
    names += (names.empty() ? "" : ", ") + robot.name;
  }
  throw ReadError("no robot '" + std::string(name) + "'; there are " + names);
}

const Robot* robot_of_scans(const OpenOptions& options) {
  if (options.robot.empty()) return nullptr;
  const Robot& robot = robot_named(options.robot);
  return options.topic.empty() || options.topic == robot.topic ? &robot : nullptr;
}

OpenOptions with_robot(OpenOptions options) {
  if (options.robot.empty()) return options;
  const Robot& robot = robot_named(options.robot);
  if (options.rate_hz <= 0.0) options.rate_hz = robot.rate_hz;
  options.repair_at_once = true;
  return options;
}

}  // namespace surefoot::io
