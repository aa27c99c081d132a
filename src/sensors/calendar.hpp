// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace surefoot::sensors {

/// Seconds since the epoch of a date (UTC) in six bytes: year, month, day, hour, minute, second.
/// Whatever their manuals say, sensors count the years from 1900 or 2000: of either the last two
/// digits are the year's, of 1970 to 2069. A year of zero may mean that the other five are the
/// seconds themselves, most significant first, as a sensor that is synchronised by PTP sends them.
/// Nothing where they are no date. @param bytes at least six.
[[nodiscard]] inline std::optional<std::int64_t> unix_seconds(std::span<const std::byte> bytes) {
  const auto value = [&](std::size_t i) { return std::to_integer<unsigned>(bytes[i]); };
  const int digits = static_cast<int>(value(0) % 100);
  const std::chrono::year_month_day date{std::chrono::year(digits + (digits < 70 ? 2000 : 1900)),
                                         std::chrono::month(value(1)), std::chrono::day(value(2))};
  if (date.ok() && value(3) < 24 && value(4) < 60 && value(5) <= 60) {
    const std::chrono::sys_seconds seconds =
        std::chrono::sys_days(date) + std::chrono::hours(value(3)) + std::chrono::minutes(value(4));
    return seconds.time_since_epoch().count() + value(5);
  }
  if (value(0) != 0) {
    return std::nullopt;
  }
  std::int64_t seconds = 0;
  for (std::size_t i = 1; i < 6; ++i) {
    seconds = seconds * 256 + static_cast<std::int64_t>(value(i));
  }
  constexpr std::int64_t kYear2106 = 4'294'967'296;  // in nanoseconds such are still numbers
  return seconds < kYear2106 ? std::optional(seconds) : std::nullopt;
}

}  // namespace surefoot::sensors
