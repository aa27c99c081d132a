// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace surefoot {

/// [s] of a span in nanoseconds, the unit of all stamps. Subtract stamps first: a double holds the
/// time since 1970 to a quarter of a microsecond only.
[[nodiscard]] inline double seconds(std::int64_t span_ns) {
  return static_cast<double>(span_ns) * 1e-9;
}

}  // namespace surefoot
