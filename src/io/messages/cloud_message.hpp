// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages that hold the points of one scan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/bags/message_source.hpp"
#include "io/point_table.hpp"

namespace surefoot::io {

/// The points look into the message's bytes, which must outlive it, or into the table's storage.
struct CloudMessage {
  std::int64_t stamp_ns = 0;
  std::string frame;
  std::optional<unsigned> lidar;  ///< number of the sensor, where messages have one
  PointTable table;
};

/// "frame 'lidar'", "frame 'livox_frame', LiDAR 2".
[[nodiscard]] std::string sensor_of(const CloudMessage& cloud);

/// Why points on such a topic in such a frame are no scans as a LiDAR measured them; empty: they
/// may be.
[[nodiscard]] std::string why_no_scans(std::string_view topic, std::string_view frame);

/// sensor_msgs/PointCloud2, and Livox's CustomMsg of both drivers.
[[nodiscard]] bool is_cloud_type(std::string_view type);

/// Throws ReadError where the message is not what its type asks for, or is big-endian.
[[nodiscard]] CloudMessage read_cloud(std::string_view type, MessageEncoding encoding,
                                      std::span<const std::byte> bytes);

}  // namespace surefoot::io
