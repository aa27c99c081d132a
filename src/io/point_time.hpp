// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the values of a point-time field mean. Drivers write seconds or nanoseconds (and some ms or
// us), counted from the scan's stamp or from the epoch; files do not say which.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "io/point_table.hpp"
#include "io/recording.hpp"

namespace surefoot::io {

/// Smallest and largest value of a scan's time field, over the points that are returns.
struct TimeExtents {
  double least = 0.0;
  double greatest = 0.0;
  std::size_t count = 0;
  std::size_t stray = 0;  ///< values of points that are none
};

/// The meaning of a time field; never "auto".
struct PointTimeRule {
  TimeUnit unit = TimeUnit::seconds;
  TimeReference reference = TimeReference::relative;
  /// The values admit only this meaning. Not so where all are equal, where they fit no stamp (a
  /// clock of its own, or a stamp that is wrong), or where the stamp is so near
  /// zero that relative and absolute cannot be told apart: then another scan may know better.
  bool certain = true;
  /// The unit, too: not where the scan would be long, and a short one in the next finer unit, as of
  /// a sensor's first packets. Then the longest of several scans knows best.
  bool unit_certain = true;
  double spread = 0.0;  ///< of the values that it is from
  double step = 0.0;    ///< of these as their type holds them; 0: no matter

  /// Absolute times in a float32 may be no times: nearly all points of a sweep have the same few.
  [[nodiscard]] bool is_too_coarse() const { return spread > 0.0 && 4.0 * step > spread; }
};

/// Whether a scan's rule is to be believed instead of that of one before.
[[nodiscard]] inline bool knows_better(const PointTimeRule& rule, const PointTimeRule& before) {
  return rule.certain != before.certain ? rule.certain : rule.spread > before.spread;
}

/// Whether two scans in a row that are about equally long confirm each other: a sensor's first
/// packets are shorter than the scan after them, and a clock of its own stays one. They do not
/// where both lie so near zero that relative and absolute are alike.
[[nodiscard]] inline bool confirms(const PointTimeRule& rule, const PointTimeRule& before) {
  constexpr double kAlike = 1.5;
  const bool is_vague =
      !rule.certain && rule.spread > 0.0 && rule.reference != TimeReference::own_clock;
  return !is_vague && rule.unit == before.unit && rule.reference == before.reference &&
         rule.spread <= kAlike * before.spread && before.spread <= kAlike * rule.spread;
}

/// The options with the unit of a time field that is defined by who made the points: Livox's
/// offset_time and Ouster's t are in nanoseconds, however short a scan is; time_us says it.
[[nodiscard]] OpenOptions with_defined_unit(OpenOptions options, const PointTable& table,
                                            const Column& time);

/// Finds the rule from one scan's values:
///  - unit: values of the size of an epoch time (2001 to 2100) tell it by their size; others by
///    their spread, as a scan lasts between 10 ms and 1 s (with a margin where no other unit is
///    near);
///  - relative if the values lie around zero, absolute if around `stamp_ns` or of epoch size.
/// What the options fix is not guessed. Throws ReadError naming the values where no rule fits.
[[nodiscard]] PointTimeRule decide_point_time(const TimeExtents& extents, ScalarType type,
                                              std::optional<std::int64_t> stamp_ns,
                                              const OpenOptions& options);

/// "time field 'time': f32, seconds relative to the stamp, 0 .. 0.0996".
[[nodiscard]] std::string describe_point_time(const std::string& field, ScalarType type,
                                              const PointTimeRule& rule,
                                              const TimeExtents& extents);

/// Nanoseconds in one unit (not for automatic).
[[nodiscard]] std::int64_t nanoseconds_in(TimeUnit unit);

/// A time value in nanoseconds, exactly rounded; nothing where it is not finite or too large.
template <typename T>
[[nodiscard]] inline std::optional<std::int64_t> to_nanoseconds(T value, std::int64_t scale) {
  if constexpr (std::is_floating_point_v<T>) {
    const auto wide = static_cast<double>(value);
    if (!(std::abs(wide) < 9.2e18 / static_cast<double>(scale))) {
      return std::nullopt;
    }
    const auto whole = static_cast<std::int64_t>(wide);
    const double fraction = wide - static_cast<double>(whole);  // exact
    return whole * scale + std::llrint(fraction * static_cast<double>(scale));
  } else {
    std::int64_t result = 0;
    const bool overflow = __builtin_mul_overflow(value, scale, &result);
    return overflow ? std::nullopt : std::optional(result);
  }
}

}  // namespace surefoot::io
