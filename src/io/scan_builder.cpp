// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/scan_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/returns.hpp"
#include "io/decimal_time.hpp"
#include "io/saturated.hpp"

namespace surefoot::io {
namespace {

constexpr std::array<std::string_view, 11> kTimeNames = {
    "t",          "time",  "timestamp", "time_stamp",     "offset_time", "time_offset",
    "timeoffset", "stamp", "time_us",   "time_offset_ns", "timestamp_ns"};
// Where LOAM's descendants put milliseconds; in other clouds it is what it says.
constexpr std::string_view kCurvature = "curvature";
constexpr double kLeastMilliseconds = 10.0;  // of a scan; no curvature spreads as far
// Labels of points spread as far, and are few. A time has a firing's points, or of a small cloud
// some.
constexpr std::size_t kFewestTimes = 64, kMostOfATime = 4;
constexpr std::array<std::string_view, 3> kRingNames = {"ring", "line", "channel"};
constexpr std::array<std::string_view, 2> kIntensityNames = {"intensity", "reflectivity"};

constexpr std::int64_t kNoTime = std::numeric_limits<std::int64_t>::min();

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    plain += (c >= 'A' && c <= 'Z') ? static_cast<char>(c - 'A' + 'a') : c;
  }
  constexpr std::string_view kCloudCompare = "scalar_";
  return plain.starts_with(kCloudCompare) ? plain.substr(kCloudCompare.size()) : plain;
}

// The column of the first of the names that there is.
const Column* find_one_of(const PointTable& table, std::span<const std::string_view> names) {
  for (const std::string_view name : names) {
    for (const Column& column : table.columns) {
      if (plain_name(column.name) == name) {
        return &column;
      }
    }
  }
  return nullptr;
}

std::vector<Eigen::Vector3f> points_of(const PointTable& table, const ScanColumns& columns) {
  std::vector<Eigen::Vector3f> points(table.size);
  const std::array<const Column*, 3> axes = {columns.x, columns.y, columns.z};
  for (int axis = 0; axis < 3; ++axis) {
    for_each_value(*axes[static_cast<std::size_t>(axis)], table.size,
                   [&](std::size_t i, auto value) { points[i][axis] = static_cast<float>(value); });
  }
  return points;
}

// What coordinates lose that are stored with more digits than a float has.
double rounding_of(const PointTable& table, const ScanColumns& columns) {
  double most = 0.0;
  for (const Column* axis : {columns.x, columns.y, columns.z}) {
    if (size_of(axis->type) < 4 || axis->type == ScalarType::f32) continue;
    for_each_value(*axis, table.size, [&](std::size_t, auto value) {
      const auto wide = static_cast<double>(value);
      const double lost = std::abs(wide - static_cast<double>(static_cast<float>(wide)));
      if (lost > most && std::isfinite(lost)) most = lost;
    });
  }
  return most;
}

std::vector<float> floats_of(const Column& column, std::size_t size) {
  std::vector<float> values(size);
  for_each_value(column, size,
                 [&](std::size_t i, auto value) { values[i] = static_cast<float>(value); });
  return values;
}

std::vector<std::uint16_t> rings_of(const Column& column, std::size_t size) {
  std::vector<std::uint16_t> rings(size);
  for_each_value(column, size, [&]<typename T>(std::size_t i, T value) {
    if constexpr (std::is_unsigned_v<T> && sizeof(T) <= sizeof(std::uint16_t)) {
      rings[i] = value;
    } else {
      const auto wide = static_cast<double>(value);
      rings[i] =
          wide >= 0.0 ? static_cast<std::uint16_t>(std::min(wide, 65535.0)) : std::uint16_t{0};
    }
  });
  return rings;
}

// Where nearly all values lie, and a margin to both sides: what lies beyond is stray. A regular
// sample of the values does.
struct UsualValues {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  [[nodiscard]] bool holds(double value) const { return least <= value && value <= greatest; }
};

// `margins`: of the width of where nearly all lie, but at least `least_margin`.
UsualValues usual_values(const std::vector<double>& values, double margins, double least_margin) {
  constexpr std::size_t kLookedAt = 2000;
  constexpr double kTail = 0.05;
  if (values.size() < 100) return {};  // too few to call one of them stray
  std::vector<double> sample;
  for (std::size_t i = 0; i < values.size(); i += values.size() / kLookedAt + 1) {
    sample.push_back(values[i]);
  }
  std::sort(sample.begin(), sample.end());
  const auto tail = static_cast<std::size_t>(kTail * static_cast<double>(sample.size()));
  const double low = sample[tail], high = sample[sample.size() - 1 - tail];
  const double margin = std::max(margins * (high - low), least_margin);
  return {low - margin, high + margin};
}

// Point times in nanoseconds as the field counts them, and their extents over the returns.
struct FieldTimes {
  std::vector<std::int64_t> ns;  ///< kNoTime where there is none
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::int64_t greatest = std::numeric_limits<std::int64_t>::min();

  [[nodiscard]] bool any_return() const { return least <= greatest; }
};

FieldTimes field_times(const Column& column, const std::vector<Eigen::Vector3f>& points,
                       std::int64_t scale) {
  FieldTimes times;
  times.ns.resize(points.size());
  for_each_value(column, points.size(), [&](std::size_t i, auto value) {
    times.ns[i] = to_nanoseconds(value, scale).value_or(kNoTime);
  });
  // Every few points tell where nearly all lie.
  constexpr std::size_t kLookedAt = 8000;
  std::vector<double> of_returns;
  for (std::size_t i = 0; i < points.size(); i += points.size() / kLookedAt + 1) {
    const bool counts = times.ns[i] != kNoTime && is_return(points[i]);
    if (counts) of_returns.push_back(static_cast<double>(times.ns[i]));
  }
  constexpr double kUsualScan = 1e8;  // [ns] all of it may lie beside where nearly all returns are
  const UsualValues usual = usual_values(of_returns, 1.0, kUsualScan);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int64_t ns = times.ns[i];
    if (ns == kNoTime || !is_return(points[i]) || !usual.holds(static_cast<double>(ns))) continue;
    times.least = std::min(times.least, ns);
    times.greatest = std::max(times.greatest, ns);
  }
  return times;
}

// Whether a column has as many different values as one has of times.
bool has_many_values(const PointTable& table, const Column& column) {
  const std::size_t enough = std::min(kFewestTimes, table.size / kMostOfATime + 1);
  std::vector<double> known;
  for_each_value(column, table.size, [&](std::size_t, auto value) {
    const auto wide = static_cast<double>(value);
    if (known.size() == enough || std::isnan(wide)) return;
    if (std::find(known.begin(), known.end(), wide) == known.end()) known.push_back(wide);
  });
  return known.size() == enough;
}

bool times_in_curvature(const PointTable& table, const Column& curvature) {
  const auto axis = [&table](std::string_view name) { return find_one_of(table, {&name, 1}); };
  const ScanColumns columns{axis("x"), axis("y"), axis("z"), nullptr, nullptr, &curvature};
  const TimeExtents extents = time_extents(table, columns);
  return extents.greatest - extents.least >= kLeastMilliseconds &&
         has_many_values(table, curvature);
}

// Coordinates of a byte each are none, and those that share their bytes neither: either would
// become many times as large here.
void check_coordinates(const ScanColumns& columns) {
  const std::array<const Column*, 3> axes = {columns.x, columns.y, columns.z};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Column& one = *axes[i];
    if (size_of(one.type) < 2) {
      throw ReadError("field '" + one.name + "' is " + name_of(one.type) +
                      "; expected coordinates of 2, 4 or 8 bytes");
    }
    const Column& other = *axes[(i + 1) % axes.size()];
    const std::byte* const begin = std::min(one.first, other.first);
    const Column& former = begin == one.first ? one : other;
    const std::byte* const next = std::max(one.first, other.first);
    if (begin != nullptr && next < begin + size_of(former.type)) {
      throw ReadError("fields '" + one.name + "' and '" + other.name + "' share bytes");
    }
  }
}

constexpr std::int64_t kFarthest = std::numeric_limits<std::int32_t>::max();  // [ns] from the stamp

bool is_near(const FieldTimes& times, std::int64_t origin) {
  std::int64_t first = 0;
  std::int64_t last = 0;
  const bool overflow = __builtin_sub_overflow(times.least, origin, &first) ||
                        __builtin_sub_overflow(times.greatest, origin, &last);
  return !overflow && first >= -kFarthest && last <= kFarthest;
}

// What has to be taken from the field's times so that they count from the stamp.
std::int64_t origin_of(const FieldTimes& times, TimeReference reference, std::int64_t stamp_ns,
                       StampAt stamp_at) {
  const bool at_end = stamp_at == StampAt::end;
  // A stamp that is far from its points is wrong by itself, and repaired where stamps are.
  if (reference == TimeReference::absolute && is_near(times, stamp_ns)) return stamp_ns;
  if (reference != TimeReference::relative) return at_end ? times.greatest : times.least;
  return at_end && times.least >= 0 ? times.greatest : 0;
}

void check_offsets(const FieldTimes& times, std::int64_t origin) {
  if (is_near(times, origin)) return;
  throw ReadError("point times: from " + format_seconds(times.least) + " to " +
                  format_seconds(times.greatest) + " s, counted from " + format_seconds(origin) +
                  " s; expected no more than 2.1 s between a point and its scan's stamp");
}

// Moves the elements of the points that stay to the front.
template <typename T>
void keep_only(std::vector<T>& values, const std::vector<std::size_t>& kept) {
  if (values.empty()) {
    return;
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    values[i] = values[kept[i]];
  }
  values.resize(kept.size());
}

void count_dropped(const Eigen::Vector3f& point, BuiltScan& built) {
  if (is_return(point)) {
    ++built.dropped_points;
  } else {
    ++(point.allFinite() ? built.dropped_zero : built.dropped_not_finite);
  }
}

// Sets times_ns and `kept`; points without a usable time go.
void set_times(BuiltScan& built, const FieldTimes& times, std::int64_t origin) {
  Scan& scan = built.scan;
  const auto is_usable = [&](std::int64_t ns) { return ns >= times.least && ns <= times.greatest; };
  scan.times_ns.resize(times.ns.size());
  std::size_t usable = 0;
  for (std::size_t i = 0; i < times.ns.size(); ++i) {
    // Of those that go the difference may be anything.
    scan.times_ns[i] = static_cast<std::int32_t>(static_cast<std::uint64_t>(times.ns[i]) -
                                                 static_cast<std::uint64_t>(origin));
    usable += is_usable(times.ns[i]) ? 1 : 0;
  }
  if (usable == times.ns.size()) return;
  std::vector<std::size_t>& kept = built.kept;
  kept.reserve(usable);
  for (std::size_t i = 0; i < times.ns.size(); ++i) {
    if (is_usable(times.ns[i])) {
      kept.push_back(i);
    } else {
      count_dropped(scan.points[i], built);
    }
  }
  keep_only(scan.points, kept);
  keep_only(scan.intensities, kept);
  keep_only(scan.rings, kept);
  keep_only(scan.times_ns, kept);
}

}  // namespace

ScanColumns find_scan_columns(const PointTable& table, const OpenOptions& options) {
  ScanColumns columns;
  const auto one = [&table](std::string_view name) { return find_one_of(table, {&name, 1}); };
  columns.x = one("x");
  columns.y = one("y");
  columns.z = one("z");
  if (columns.x == nullptr || columns.y == nullptr || columns.z == nullptr) {
    throw ReadError("fields are '" + table.layout() + "'; expected x, y and z among them");
  }
  if (table.size > 0) check_coordinates(columns);  // no points may have no memory
  columns.intensity = find_one_of(table, kIntensityNames);
  columns.ring = find_one_of(table, kRingNames);
  if (options.time_field.empty()) {
    columns.time = find_one_of(table, kTimeNames);
    const Column* const curvature = find_one_of(table, {&kCurvature, 1});
    if (columns.time == nullptr && curvature != nullptr && times_in_curvature(table, *curvature)) {
      columns.time = curvature;
    }
  } else {
    columns.time = table.find(options.time_field);
    if (columns.time == nullptr) {
      throw ReadError("no field '" + options.time_field + "' for the point times; fields are '" +
                      table.layout() + "'");
    }
  }
  return columns;
}

bool is_time_name(std::string_view name) {
  return std::count(kTimeNames.begin(), kTimeNames.end(), plain_name(name)) > 0;
}

bool may_be_times(const PointTable& table, const Column& column) {
  if (plain_name(column.name) != kCurvature) return is_time_name(column.name);
  return times_in_curvature(table, column);
}

TimeExtents time_extents(const PointTable& table, const ScanColumns& columns) {
  const std::vector<Eigen::Vector3f> points = points_of(table, columns);
  std::vector<double> values;
  values.reserve(table.size);
  for_each_value(*columns.time, table.size, [&](std::size_t i, auto value) {
    const auto wide = static_cast<double>(value);
    if (std::isfinite(wide) && is_return(points[i])) values.push_back(wide);
  });
  constexpr double kMargins = 20.0;  // the unit is not known yet
  const UsualValues usual = usual_values(values, kMargins, 0.0);
  TimeExtents extents;
  for (const double value : values) {
    if (!usual.holds(value)) {
      ++extents.stray;
      continue;
    }
    extents.least = extents.count == 0 ? value : std::min(extents.least, value);
    extents.greatest = extents.count == 0 ? value : std::max(extents.greatest, value);
    ++extents.count;
  }
  return extents;
}

BuiltScan build_scan(const PointTable& table, const ScanColumns& columns,
                     const std::optional<PointTimeRule>& rule, std::optional<std::int64_t> stamp_ns,
                     StampAt stamp_at) {
  BuiltScan built;
  Scan& scan = built.scan;
  scan.stamp_ns = sane_time(stamp_ns.value_or(0));
  scan.points = points_of(table, columns);
  built.rounded_by = rounding_of(table, columns);
  if (columns.intensity != nullptr) {
    scan.intensities = floats_of(*columns.intensity, table.size);
  }
  if (columns.ring != nullptr) {
    scan.rings = rings_of(*columns.ring, table.size);
  }
  if (columns.time == nullptr || !rule) {
    return built;
  }
  const FieldTimes times = field_times(*columns.time, scan.points, nanoseconds_in(rule->unit));
  if (!times.any_return()) {
    scan.times_ns.assign(scan.points.size(), 0);
    return built;
  }
  if (!stamp_ns && rule->reference == TimeReference::absolute) {
    scan.stamp_ns = sane_time(times.least);
  }
  if (rule->is_too_coarse()) return built;
  const std::int64_t origin = origin_of(times, rule->reference, scan.stamp_ns, stamp_at);
  check_offsets(times, origin);
  if (rule->reference != TimeReference::relative) {
    built.clock = PointClock{sane_time(times.least), sane_time(origin)};
  }
  set_times(built, times, origin);
  return built;
}

}  // namespace surefoot::io
