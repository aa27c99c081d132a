// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/messages/cloud_message.hpp"
#include "io/messages/message_reader.hpp"

namespace surefoot::io {

/// Livox's CustomMsg: columns offset_time [ns], x, y, z, reflectivity, tag, line. The stamp is the
/// time base that the offsets count from; the header's where the time base is of another clock.
/// Throws ReadError.
[[nodiscard]] CloudMessage read_livox_message(MessageReader& reader);

}  // namespace surefoot::io
