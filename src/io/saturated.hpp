// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps in files may be anything: sums of them stay within the range of the type.
#pragma once

#include <cstdint>
#include <limits>

namespace surefoot::io {

[[nodiscard]] inline std::int64_t sum(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  if (!__builtin_add_overflow(a, b, &result)) return result;
  return b > 0 ? std::numeric_limits<std::int64_t>::max()
               : std::numeric_limits<std::int64_t>::min();
}

[[nodiscard]] inline std::int64_t difference(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  if (!__builtin_sub_overflow(a, b, &result)) return result;
  return b < 0 ? std::numeric_limits<std::int64_t>::max()
               : std::numeric_limits<std::int64_t>::min();
}

[[nodiscard]] inline std::int64_t times(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  if (!__builtin_mul_overflow(a, b, &result)) return result;
  return (a > 0) == (b > 0) ? std::numeric_limits<std::int64_t>::max()
                            : std::numeric_limits<std::int64_t>::min();
}

/// How far apart two are, whichever is the later.
[[nodiscard]] inline std::int64_t distance(std::int64_t a, std::int64_t b) {
  return a > b ? difference(a, b) : difference(b, a);
}

/// A time as it is stored, kept within what times may be added to and subtracted from
/// without a thought: 1834 to 2106.
[[nodiscard]] constexpr std::int64_t sane_time(std::int64_t nanoseconds) {
  constexpr std::int64_t kMost = 4'294'967'296'000'000'000;
  return nanoseconds > kMost ? kMost : nanoseconds < -kMost ? -kMost : nanoseconds;
}

}  // namespace surefoot::io
