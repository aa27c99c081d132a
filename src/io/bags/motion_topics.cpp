// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/motion_topics.hpp"

#include <algorithm>

#include "io/bags/bag_files.hpp"
#include "io/messages/motion_message.hpp"
#include "io/recording.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::io {
namespace {

// Gaps of a gyroscope that are still bridged [s].
constexpr double kLongestStep = 0.1;
// Messages may be out of order by so much [ns].
constexpr std::int64_t kLate = 2'000'000'000;

// Names of the topics with poses, in the order they appear; all of the bag is read.
std::vector<std::string> pose_topics(const std::filesystem::path& bag) {
  std::vector<std::string> names;
  const auto source = open_bag(bag);
  while (const std::optional<Message> message = source->next()) {
    const Topic& topic = *message->topic;
    const bool known = std::find(names.begin(), names.end(), topic.name) != names.end();
    if (!known && is_pose_type(topic.type)) names.push_back(topic.name);
  }
  return names;
}

std::string only_pose_topic(const std::filesystem::path& bag) {
  const std::vector<std::string> names = pose_topics(bag);
  if (names.size() == 1) return names.front();
  std::string text = bag.string() + ": " + std::to_string(names.size()) + " topics with poses";
  for (const std::string& name : names) text += "\n  " + name;
  throw ReadError(text + (names.empty() ? "" : "\nname one"));
}

void go_on(Trajectory& turning, const Turning& next) {
  if (turning.empty()) {
    turning.push_back({next.stamp_ns, {}});
    return;
  }
  const double step = seconds(next.stamp_ns - turning.back().stamp_ns);
  if (!(step > 0.0)) return;  // out of order, or twice
  StampedPose pose = turning.back();
  pose.stamp_ns = next.stamp_ns;
  pose.pose.rotation =
      (pose.pose.rotation * so3_exp(next.rate * std::min(step, kLongestStep))).normalized();
  turning.push_back(pose);
}

}  // namespace

PoseTopic read_pose_topic(const std::filesystem::path& bag, const std::string& topic) {
  const std::string name = topic.empty() ? only_pose_topic(bag) : topic;
  const auto source = open_bag(bag);
  source->want(name);
  PoseTopic read;
  while (const std::optional<Message> message = source->next()) {
    if (message->topic->name != name) continue;
    if (!is_pose_type(message->topic->type)) {
      throw ReadError(bag.string() + ": " + name + " is of type " + message->topic->type +
                      "; expected poses: Odometry, PoseStamped, TransformStamped or PointStamped");
    }
    try {
      const auto [pose, has_rotation] = read_pose(*message);
      if (!read.poses.empty() && pose.stamp_ns <= read.poses.back().stamp_ns) continue;
      read.poses.push_back(pose);
      read.has_rotations = read.has_rotations && has_rotation;
    } catch (const ReadError&) {
      continue;  // one bad message is no reason to lose the others
    }
  }
  if (read.poses.empty()) throw ReadError(bag.string() + ": no pose on topic '" + name + "'");
  return read;
}

Gyroscope read_gyroscope(const std::filesystem::path& bag, std::int64_t begin_ns,
                         std::int64_t end_ns) {
  Gyroscope gyroscope;
  const auto source = open_bag(bag);
  // Its own headers alone tell the end: other topics may lie before it, and clocks may differ.
  bool is_over = false;
  while (!is_over || source->leave_file()) {
    is_over = false;
    const std::optional<Message> message = source->next();
    if (!message) break;
    const Topic& topic = *message->topic;
    if (topic.type != "sensor_msgs/Imu") continue;
    if (gyroscope.topic.empty()) {
      gyroscope.topic = topic.name;
      source->want(topic.name);
    }
    if (topic.name != gyroscope.topic) continue;
    try {
      const Turning turning = read_imu(*message);
      is_over = turning.stamp_ns - kLate > end_ns;
      const bool inside = turning.stamp_ns >= begin_ns && turning.stamp_ns <= end_ns;
      if (inside && turning.rate.allFinite()) go_on(gyroscope.turning, turning);
    } catch (const ReadError&) {
      continue;
    }
  }
  return gyroscope;
}

}  // namespace surefoot::io
