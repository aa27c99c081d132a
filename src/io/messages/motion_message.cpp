// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/motion_message.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/messages/message_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::array<std::string_view, 5> kPoseTypes = {
    "nav_msgs/Odometry", "geometry_msgs/PoseStamped", "geometry_msgs/PoseWithCovarianceStamped",
    "geometry_msgs/TransformStamped", "geometry_msgs/PointStamped"};

Eigen::Vector3d vector_of(MessageReader& reader, const char* what) {
  reader.begin_structure();
  const double x = reader.number<double>(what), y = reader.number<double>(what);
  return {x, y, reader.number<double>(what)};
}

/// None: four zeros, by which some say that they do not know.
std::optional<Eigen::Quaterniond> rotation_of(MessageReader& reader) {
  reader.begin_structure();
  const double x = reader.number<double>("rotation"), y = reader.number<double>("rotation");
  const double z = reader.number<double>("rotation"), w = reader.number<double>("rotation");
  const Eigen::Quaterniond rotation(w, x, y, z);
  const double norm = rotation.norm();
  if (norm == 0.0) return std::nullopt;
  if (!(norm > 0.5 && norm < 2.0)) throw ReadError("a rotation that is no unit quaternion");
  return rotation.normalized();
}

/// Structures about a position: a Pose or Transform, and what joins it with its covariance.
int structures_about_position(const std::string& type) {
  if (type == "geometry_msgs/PointStamped") return 0;
  return type == "nav_msgs/Odometry" || type == "geometry_msgs/PoseWithCovarianceStamped" ? 2 : 1;
}

}  // namespace

bool is_pose_type(const std::string& type) {
  return std::find(kPoseTypes.begin(), kPoseTypes.end(), type) != kPoseTypes.end();
}

PoseMessage read_pose(const Message& message) {
  MessageReader reader(message.topic->encoding, message.bytes);
  reader.begin_structure();
  PoseMessage told;
  told.pose.stamp_ns = read_header(reader).stamp_ns;
  const std::string& type = message.topic->type;
  if (type == "nav_msgs/Odometry" || type == "geometry_msgs/TransformStamped") {
    (void)reader.string("child frame");
  }
  for (int i = 0; i < structures_about_position(type); ++i) reader.begin_structure();
  told.pose.pose.translation = vector_of(reader, "position");
  if (!told.pose.pose.translation.allFinite()) throw ReadError("a position that is not finite");
  std::optional<Eigen::Quaterniond> rotation;
  if (type != "geometry_msgs/PointStamped") rotation = rotation_of(reader);
  told.has_rotation = rotation.has_value();
  told.pose.pose.rotation = rotation.value_or(Eigen::Quaterniond::Identity());
  return told;
}

Turning read_imu(const Message& message) {
  MessageReader reader(message.topic->encoding, message.bytes);
  reader.begin_structure();
  Turning turning;
  turning.stamp_ns = read_header(reader).stamp_ns;
  reader.begin_structure();  // the orientation
  for (int i = 0; i < 13; ++i) (void)reader.number<double>("orientation and its covariance");
  turning.rate = vector_of(reader, "angular velocity");
  return turning;
}

}  // namespace surefoot::io
