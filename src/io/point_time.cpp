// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/point_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

#include "surefoot/seconds.hpp"

namespace surefoot::io {
namespace {

struct UnitFacts {
  TimeUnit unit;
  const char* name;
  double per_second;
};
constexpr std::array<UnitFacts, 4> kUnits = {{{TimeUnit::seconds, "seconds", 1.0},
                                              {TimeUnit::milliseconds, "milliseconds", 1e3},
                                              {TimeUnit::microseconds, "microseconds", 1e6},
                                              {TimeUnit::nanoseconds, "nanoseconds", 1e9}}};

// Epoch times from September 2001 to February 2103 [s].
constexpr double kEpochLeast = 1e9;
constexpr double kEpochGreatest = 4.2e9;

// How far from a scan's stamp its points may be, where the points do not include the stamp: the
// longest scan that is one without a warning [s].
constexpr double kNear = 1.0;
// No scan takes longer [s]: values of this size count another unit from a later start.
constexpr double kLongest = 10.0;
// Shorter scans are unusual [s].
constexpr double kShortest = 0.01;
// Of longer ones a thousandth may be a scan, too: a packet or more [s].
constexpr double kLongestSure = 0.15;
// Stamps nearer to zero than this cannot tell absolute from relative [s].
constexpr double kStampNearZero = 2.0 * kNear;

const UnitFacts& facts_of(TimeUnit unit) {
  return kUnits[static_cast<std::size_t>(unit) - static_cast<std::size_t>(TimeUnit::seconds)];
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.12g", value);
  return text;
}

std::string seen(const TimeExtents& extents, ScalarType type) {
  return std::string(name_of(type)) + " values " + number(extents.least) + " .. " +
         number(extents.greatest);
}

std::optional<TimeUnit> unit_by_epoch(const TimeExtents& extents) {
  for (const UnitFacts& facts : kUnits) {
    const bool is_scan = extents.greatest - extents.least <= kLongest * facts.per_second;
    if (is_scan && extents.least >= kEpochLeast * facts.per_second &&
        extents.greatest <= kEpochGreatest * facts.per_second) {
      return facts.unit;
    }
  }
  return std::nullopt;
}

// Scans of 10 ms to 1 s spread over 0.01..1, 10..1e3, 1e4..1e6, 1e7..1e9. The gaps belong to the
// unit that drivers use: seconds if floating, and nanoseconds, for shorter and longer scans.
std::optional<TimeUnit> unit_by_spread(double spread, ScalarType type) {
  if (spread < 10.0) {
    return is_float(type) ? std::optional(TimeUnit::seconds) : std::nullopt;
  }
  if (spread <= 1e3) {
    return TimeUnit::milliseconds;
  }
  if (spread >= 9e3 && spread <= 1e6) {
    return TimeUnit::microseconds;
  }
  return spread > 1e6 && spread <= 1e10 ? std::optional(TimeUnit::nanoseconds) : std::nullopt;
}

// All values equal: nothing tells the unit, and for zero nothing depends on it.
std::optional<TimeUnit> unit_of_constant(double value, std::optional<std::int64_t> stamp_ns,
                                         ScalarType type) {
  if (stamp_ns) {
    const double stamp = seconds(*stamp_ns);
    for (const UnitFacts& facts : kUnits) {
      if (std::abs(value / facts.per_second - stamp) <= kNear) {
        return facts.unit;
      }
    }
  }
  if (value == 0.0) {
    return is_float(type) ? TimeUnit::seconds : TimeUnit::nanoseconds;
  }
  return is_float(type) && std::abs(value) <= kNear ? std::optional(TimeUnit::seconds)
                                                    : std::nullopt;
}

std::optional<TimeUnit> find_unit(const TimeExtents& extents, ScalarType type,
                                  std::optional<std::int64_t> stamp_ns) {
  if (const std::optional<TimeUnit> unit = unit_by_epoch(extents)) {
    return unit;
  }
  const double spread = extents.greatest - extents.least;
  return spread > 0.0 ? unit_by_spread(spread, type)
                      : unit_of_constant(extents.least, stamp_ns, type);
}

bool around(double instant, double least, double greatest) {
  return least - kNear <= instant && instant <= greatest + kNear;
}

// Relative or absolute, from the values in seconds; clears `certain` where both would fit.
std::optional<TimeReference> find_reference(double least, double greatest,
                                            std::optional<std::int64_t> stamp_ns, bool& certain) {
  const double stamp = stamp_ns ? seconds(*stamp_ns) : 0.0;
  const bool fits_relative = around(0.0, least, greatest);
  const bool fits_absolute = stamp_ns && around(stamp, least, greatest);
  if (fits_relative && fits_absolute) {
    certain = std::abs(stamp) > kStampNearZero;
    return TimeReference::relative;
  }
  if (fits_relative) {
    return TimeReference::relative;
  }
  const bool is_epoch = least >= kEpochLeast && greatest <= kEpochGreatest;
  if (fits_absolute || (!stamp_ns && is_epoch) || (!stamp_ns && least > kNear)) {
    return TimeReference::absolute;
  }
  // A LiDAR that knows no time under the header of a host that does. The header may be the odd one.
  const bool is_scan = greatest - least >= kShortest && greatest - least <= kNear;
  if (stamp_ns && least > kNear && is_scan) {
    certain = false;
    return TimeReference::own_clock;
  }
  return std::nullopt;
}

const char* text_of(TimeReference reference) {
  switch (reference) {
    case TimeReference::own_clock:
      return " of a clock that is not the stamps', a scan's first at its stamp, ";
    case TimeReference::absolute:
      return " since the epoch (absolute), ";
    default:
      return " relative to the stamp, ";
  }
}

[[noreturn]] void fail(const TimeExtents& extents, ScalarType type,
                       std::optional<std::int64_t> stamp_ns, const char* what) {
  throw ReadError(
      "point times: " + seen(extents, type) +
      (stamp_ns ? " in a scan stamped " + number(seconds(*stamp_ns)) + " s"
                : std::string(" in a scan without a stamp")) +
      " fit no " + what +
      "; expected a spread of 0.01 to 1 s in s, ms, us or ns, around zero or around "
      "the stamp. Give the time unit and reference, or the name of another time field, or leave "
      "the times out");
}

// What a name such as "timestamp_ns" ends with.
std::optional<TimeUnit> unit_named_by(std::string_view name) {
  if (name.ends_with("_ns")) return TimeUnit::nanoseconds;
  if (name.ends_with("_us")) return TimeUnit::microseconds;
  if (name.ends_with("_ms")) return TimeUnit::milliseconds;
  return std::nullopt;
}

// Between two values of a float32 that are as far from zero.
double step_of(const TimeExtents& extents, ScalarType type) {
  if (type != ScalarType::f32) return 0.0;
  const auto value =
      static_cast<float>(std::max(std::abs(extents.least), std::abs(extents.greatest)));
  const float next = std::nextafter(value, std::numeric_limits<float>::infinity());
  return static_cast<double>(next) - static_cast<double>(value);
}

std::string coarseness(const PointTimeRule& rule, const TimeExtents& extents) {
  constexpr double kTold = 0.02;  // of a sweep
  const bool all_zero = extents.least == 0.0 && extents.greatest == 0.0;
  if (all_zero || rule.step <= kTold * rule.spread) return {};
  char text[100];
  std::snprintf(text, sizeof(text), "; float32 holds these times in steps of %.3g ms%s",
                1e3 * rule.step / facts_of(rule.unit).per_second,
                rule.is_too_coarse() ? ", too coarse for a sweep: they are left out" : "");
  return text;
}

}  // namespace

OpenOptions with_defined_unit(OpenOptions options, const PointTable& table, const Column& time) {
  const auto has = [&table](const char* name) { return table.find(name) != nullptr; };
  const bool is_livox = time.name == "offset_time" && has("tag") && has("line");
  const bool is_ouster = time.name == "t" && has("reflectivity") && has("range");
  const bool is_defined = time.type == ScalarType::u32 && (is_livox || is_ouster);
  if (options.time_unit != TimeUnit::automatic) return options;
  if (const auto named = unit_named_by(time.name)) options.time_unit = *named;
  if (is_defined) options.time_unit = TimeUnit::nanoseconds;
  return options;
}

std::int64_t nanoseconds_in(TimeUnit unit) {
  return static_cast<std::int64_t>(1e9 / facts_of(unit).per_second);
}

PointTimeRule decide_point_time(const TimeExtents& extents, ScalarType type,
                                std::optional<std::int64_t> stamp_ns, const OpenOptions& options) {
  PointTimeRule rule;
  rule.certain = extents.greatest > extents.least;
  std::optional<TimeUnit> unit = options.time_unit;
  if (unit == TimeUnit::automatic) {
    unit = find_unit(extents, type, stamp_ns);
  }
  if (!unit) {
    fail(extents, type, stamp_ns, "unit");
  }
  rule.unit = *unit;
  rule.spread = extents.greatest - extents.least;
  rule.step = step_of(extents, type);
  rule.unit_certain = options.time_unit != TimeUnit::automatic || unit_by_epoch(extents) ||
                      rule.unit == TimeUnit::nanoseconds ||
                      rule.spread <= kLongestSure * facts_of(rule.unit).per_second;
  std::optional<TimeReference> reference = options.time_reference;
  if (reference == TimeReference::automatic) {
    const double per_second = facts_of(rule.unit).per_second;
    reference = find_reference(extents.least / per_second, extents.greatest / per_second, stamp_ns,
                               rule.certain);
  }
  if (!reference) {
    fail(extents, type, stamp_ns, "reference");
  }
  rule.reference = *reference;
  return rule;
}

std::string describe_point_time(const std::string& field, ScalarType type,
                                const PointTimeRule& rule, const TimeExtents& extents) {
  const double duration = (extents.greatest - extents.least) / facts_of(rule.unit).per_second;
  const bool usual = duration == 0.0 || (duration >= kShortest && duration <= kNear);
  return "time field '" + field + "': " + name_of(type) + ", " + facts_of(rule.unit).name +
         text_of(rule.reference) + number(extents.least) + " .. " + number(extents.greatest) +
         coarseness(rule, extents) +
         (usual ? "" : "; a scan of " + number(duration) + " s is unusual, 0.01 to 1 s expected");
}

}  // namespace surefoot::io
