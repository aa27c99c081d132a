// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "sensors/firings.hpp"

namespace surefoot::sensors {

/// Whether a packet is the next one after that of `before_ns`: none was lost or swapped.
[[nodiscard]] inline bool follows(const Firings& packet, std::int64_t before_ns) {
  const std::int64_t since_ns = packet.time_ns - before_ns;
  return 2 * since_ns > packet.period_ns && 2 * since_ns < 3 * packet.period_ns;
}

}  // namespace surefoot::sensors
