// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "io/point_table.hpp"
#include "io/point_time.hpp"
#include "io/recording.hpp"
#include "io/scan_fields.hpp"

namespace surefoot::io {

/// The columns that a scan is made of; those that may be absent are null.
struct ScanColumns {
  const Column* x = nullptr;
  const Column* y = nullptr;
  const Column* z = nullptr;
  const Column* intensity = nullptr;
  const Column* ring = nullptr;
  const Column* time = nullptr;
};

/// Finds the columns by the names that drivers use, in any case and also behind CloudCompare's
/// "scalar_". Throws ReadError where x, y or z, or a time field named in the options, is missing,
/// and where coordinates have one byte each or share some.
[[nodiscard]] ScanColumns find_scan_columns(const PointTable& table, const OpenOptions& options);

/// Smallest and largest time value over the points that are returns (finite, not zero); values far
/// from nearly all others are left out.
/// `columns.time` must not be null.
[[nodiscard]] TimeExtents time_extents(const PointTable& table, const ScanColumns& columns);

struct BuiltScan {
  Scan scan;
  std::vector<std::size_t> kept;       ///< the table's points that are in it; empty: all of them
  std::size_t dropped_points = 0;      ///< returns
  std::size_t dropped_not_finite = 0;  ///< without return: NaN or infinite
  std::size_t dropped_zero = 0;
  double rounded_by = 0.0;  ///< most that a coordinate lost by becoming a float [m]
  std::optional<PointClock> clock;
};

/// Whether a field of this name is read as point times.
[[nodiscard]] bool is_time_name(std::string_view name);

/// Whether a table without other point times would have its times in that column.
[[nodiscard]] bool may_be_times(const PointTable& table, const Column& column);

/// The scan that a table holds. `rule` is needed where there is a time column. Without a `stamp_ns`
/// absolute times give it: the earliest return's; else it is zero. Points whose time is not finite
/// or far from nearly all others', and points without return whose time lies outside the returns',
/// are dropped. Rings outside
/// 0..65535 become the nearer of the two. Throws ReadError where a point lies more than 2.1 s from
/// the stamp.
[[nodiscard]] BuiltScan build_scan(const PointTable& table, const ScanColumns& columns,
                                   const std::optional<PointTimeRule>& rule,
                                   std::optional<std::int64_t> stamp_ns, StampAt stamp_at);

}  // namespace surefoot::io
