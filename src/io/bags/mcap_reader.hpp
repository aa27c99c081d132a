// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "io/bags/byte_stream.hpp"
#include "io/bags/message_source.hpp"

namespace surefoot::io {

/// The messages of an MCAP file (mcap.dev/spec) in the order they are stored. Neither summary nor
/// index is looked at: a file that is cut anywhere gives every whole message before the cut, also
/// of a chunk that was never closed. Checksums are compared where they are given; a difference is
/// noted when it is known, which is after the messages. Records of unknown kinds are passed over.
/// Throws ReadError where the file does not begin as MCAP does.
[[nodiscard]] std::unique_ptr<MessageSource> read_mcap(std::unique_ptr<ByteStream> file);

}  // namespace surefoot::io
