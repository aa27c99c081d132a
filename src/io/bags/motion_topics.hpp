// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What else in a bag knows of the sensor's motion: gyroscopes and poses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "surefoot/trajectory.hpp"

namespace surefoot::io {

struct PoseTopic {
  Trajectory poses;
  bool has_rotations = true;  ///< else some are not known: these are the identity
};
/// Poses of a bag's topic (motion_message.hpp says of which types), or, without a name, of the only
/// one that has any. Throws ReadError, also where there is no such topic or several.
[[nodiscard]] PoseTopic read_pose_topic(const std::filesystem::path& bag, const std::string& topic);

struct Gyroscope {
  std::string topic;   ///< empty: there is none in the bag
  Trajectory turning;  ///< rotations since the first message, positions zero
};
/// The first sensor_msgs/Imu topic of a bag, between the instants by its headers. Empty where there
/// is none. Throws ReadError where the bag cannot be read.
[[nodiscard]] Gyroscope read_gyroscope(const std::filesystem::path& bag, std::int64_t begin_ns,
                                       std::int64_t end_ns);

}  // namespace surefoot::io
