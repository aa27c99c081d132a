// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/messages/message_writer.hpp"
#include "io/scan_fields.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// What a message says of all its points.
struct CloudHead {
  std::int64_t stamp_ns = 0;
  std::string_view frame;
  bool dense = true;  ///< every point is finite
};

/// sensor_msgs/PointField has no integers of 64 bits.
[[nodiscard]] bool fits_point_cloud2(const Column& column);
/// Every point of the scan is finite.
[[nodiscard]] bool is_dense(const Scan& scan);

/// Columns that fit, as sensor_msgs/PointCloud2.
[[nodiscard]] std::string format_point_cloud2(const CloudHead& head,
                                              std::span<const Column> columns, std::size_t points,
                                              MessageWriter::Flavour flavour);
/// A scan with its written_columns; nothing is lost.
[[nodiscard]] std::string format_point_cloud2(const Scan& scan, std::string_view frame,
                                              MessageWriter::Flavour flavour);

}  // namespace surefoot::io
