// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/pose_messages.hpp"

namespace surefoot::io {
namespace {

void append(MessageWriter& message, const Eigen::Vector3d& vector) {
  for (int axis = 0; axis < 3; ++axis) message.number(vector[axis]);
}

void append(MessageWriter& message, const Pose& pose) {
  append(message, pose.translation);
  const Eigen::Quaterniond q(pose.rotation);
  message.number(q.x()).number(q.y()).number(q.z()).number(q.w());
}

void append(MessageWriter& message, const Matrix6& covariance) {
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) message.number(covariance(row, column));
  }
}

}  // namespace

std::string format_odometry(const OdometryMessage& odometry, MessageWriter::Flavour flavour) {
  MessageWriter message(flavour);
  message.header(odometry.stamp_ns, odometry.frame).string(odometry.child_frame);
  append(message, odometry.T_frame_child);
  append(message, odometry.covariance);
  append(message, Eigen::Vector3d(odometry.twist.head<3>()));
  append(message, Eigen::Vector3d(odometry.twist.tail<3>()));
  append(message, Matrix6(Matrix6::Zero()));
  return message.take();
}

std::string format_path(const Trajectory& poses, std::string_view frame,
                        MessageWriter::Flavour flavour) {
  MessageWriter message(flavour);
  message.header(poses.empty() ? 0 : poses.back().stamp_ns, frame).count(poses.size());
  for (const StampedPose& stamped : poses) {
    message.header(stamped.stamp_ns, frame);
    append(message, stamped.pose);
  }
  return message.take();
}

std::string format_transforms(const std::vector<Transform>& transforms,
                              MessageWriter::Flavour flavour) {
  MessageWriter message(flavour);
  message.count(transforms.size());
  for (const Transform& transform : transforms) {
    message.header(transform.stamp_ns, transform.parent).string(transform.child);
    append(message, transform.T_parent_child);
  }
  return message.take();
}

std::string format_diagnostic(const Diagnostic& diagnostic, MessageWriter::Flavour flavour) {
  MessageWriter message(flavour);
  message.header(diagnostic.stamp_ns, "").count(1);
  message.number(static_cast<std::uint8_t>(diagnostic.level));
  message.string(diagnostic.name).string(diagnostic.message).string("");
  message.count(diagnostic.values.size());
  for (const auto& [key, value] : diagnostic.values) message.string(key).string(value);
  return message.take();
}

}  // namespace surefoot::io
