// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/cloud_message.hpp"

#include "io/messages/livox_message.hpp"
#include "io/messages/point_cloud2.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

bool is_livox_type(std::string_view type) {
  return type == "livox_ros_driver/CustomMsg" || type == "livox_ros_driver2/CustomMsg" ||
         type == "livox_interfaces/CustomMsg";
}

}  // namespace

bool is_cloud_type(std::string_view type) {
  return type == "sensor_msgs/PointCloud2" || is_livox_type(type);
}

CloudMessage read_cloud(std::string_view type, MessageEncoding encoding,
                        std::span<const std::byte> bytes) {
  MessageReader reader(encoding, bytes);
  return is_livox_type(type) ? read_livox_message(reader) : read_point_cloud2(reader);
}

}  // namespace surefoot::io
