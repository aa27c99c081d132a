// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a ROS 1 bag, version 2.0, is made of; rosbag_storage, constants.h.
#pragma once

#include <cstdint>
#include <string_view>

namespace surefoot::io {

inline constexpr std::string_view kRos1BagMagic = "#ROSBAG V2.0\n";

/// What a record holds.
enum class RecordKind : std::uint8_t {
  message = 2,
  file_header = 3,
  index = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7
};

}  // namespace surefoot::io
