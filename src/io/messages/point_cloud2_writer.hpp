// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "io/messages/message_writer.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// A scan as sensor_msgs/PointCloud2: x y z f32, and where the scan has them intensity f32, t (ns
/// after the stamp, u32, or i32 where some are negative) and ring u16; nothing is lost. Throws
/// std::invalid_argument where the scan's arrays differ in length.
[[nodiscard]] std::string format_point_cloud2(const Scan& scan, std::string_view frame,
                                              MessageWriter::Flavour flavour);

}  // namespace surefoot::io
