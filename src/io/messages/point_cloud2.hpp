// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/messages/cloud_message.hpp"
#include "io/messages/message_reader.hpp"

namespace surefoot::io {

/// sensor_msgs/PointCloud2, in rows or not, padded or not. Fields of several values count as one of
/// the first. Throws ReadError.
[[nodiscard]] CloudMessage read_point_cloud2(MessageReader& reader);

}  // namespace surefoot::io
