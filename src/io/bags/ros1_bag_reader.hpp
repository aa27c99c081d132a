// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "io/bags/byte_stream.hpp"
#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// The messages of a ROS 1 bag, version 2.0, in the order they are stored; chunks plain, bz2 or
/// lz4. The index is not looked at: a bag that was never indexed, or is cut anywhere, gives every
/// whole message before the cut. Throws ReadError where the file does not begin as such a bag does.
[[nodiscard]] std::unique_ptr<MessageSource> read_ros1_bag(std::unique_ptr<ByteStream> file);

}  // namespace surefoot::io
