// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Instants as decimal text, to the nanosecond: a double holds an epoch time to 240 ns only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace surefoot::io {

/// "1630577758.569489956", "-0.1" or "1.036224e-01" [s] as nanoseconds, exactly; digits past the
/// ninth decimal are rounded (half away from zero). Nothing where it is no number or does not fit.
[[nodiscard]] std::optional<std::int64_t> parse_decimal_seconds(std::string_view text);

/// KITTI's "2011-09-26 14:30:14.950485851" (UTC) as nanoseconds since 1970, or nothing.
[[nodiscard]] std::optional<std::int64_t> parse_date_time(std::string_view text);

/// Seconds with nine decimals, exactly.
[[nodiscard]] std::string format_seconds(std::int64_t nanoseconds);

}  // namespace surefoot::io
