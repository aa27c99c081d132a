// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/cloud_message.hpp"

#include <algorithm>

#include "io/messages/livox_message.hpp"
#include "io/messages/point_cloud2.hpp"
#include "io/recording.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

bool is_livox_type(std::string_view type) {
  return type == "livox_ros_driver/CustomMsg" || type == "livox_ros_driver2/CustomMsg" ||
         type == "livox_interfaces/CustomMsg";
}

}  // namespace

std::string sensor_of(const CloudMessage& cloud) {
  return "frame '" + text::printable(cloud.frame) + "'" +
         (cloud.lidar ? ", LiDAR " + std::to_string(*cloud.lidar) : "");
}

std::string why_no_scans(std::string_view topic, std::string_view frame) {
  // A robot's name may stand before.
  const std::string_view last = frame.substr(frame.rfind('/') + 1);
  for (const std::string_view world : {"odom", "map", "world", "camera_init"}) {
    if (last == world) {
      return "points in frame '" + std::string(last) + "', a world's, are no scans as measured";
    }
  }
  std::string_view before;  // whole words; a depth camera's are registered to its pictures
  for (std::size_t begin = 0; begin < topic.size();) {
    const std::size_t end = std::min(topic.find_first_of("/_", begin), topic.size());
    const std::string_view word = topic.substr(begin, end - begin);
    const bool registered = word == "registered" && before != "depth";
    if (registered || word == "deskewed" || word == "undistorted") {
      return "points that are " + std::string(word) + " are no scans as measured";
    }
    before = word;
    begin = end + 1;
  }
  return {};
}

bool is_cloud_type(std::string_view type) {
  return type == "sensor_msgs/PointCloud2" || is_livox_type(type);
}

CloudMessage read_cloud(std::string_view type, MessageEncoding encoding,
                        std::span<const std::byte> bytes) {
  MessageReader reader(encoding, bytes);
  return is_livox_type(type) ? read_livox_message(reader) : read_point_cloud2(reader);
}

}  // namespace surefoot::io
