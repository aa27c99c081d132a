// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/preprocess.hpp"
#include "geometry/float_sums.hpp"
#include "geometry/returns.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace surefoot {

namespace {

std::string size_mismatch(const Scan& scan, const char* what, std::size_t seen) {
  return "scan of stamp " + std::to_string(scan.stamp_ns) + " ns has " + std::to_string(seen) +
         " " + what + " for " + std::to_string(scan.points.size()) +
         " points; expected none or one per point";
}

std::string check_sizes(const Scan& scan) {
  const std::size_t points = scan.points.size();
  if (!scan.times_ns.empty() && scan.times_ns.size() != points) {
    return size_mismatch(scan, "times", scan.times_ns.size());
  }
  if (!scan.intensities.empty() && scan.intensities.size() != points) {
    return size_mismatch(scan, "intensities", scan.intensities.size());
  }
  if (!scan.rings.empty() && scan.rings.size() != points) {
    return size_mismatch(scan, "rings", scan.rings.size());
  }
  return {};
}

/// [ns] from the stamp to the first and to the last instant; of all points, so that what is out of
/// range does not move mid-scan.
struct Interval {
  std::int32_t first = 0, last = 0;
};

Interval interval_of(const Scan& scan) {
  if (scan.times_ns.empty()) return {};
  Interval interval{scan.times_ns.front(), scan.times_ns.front()};
  for (const std::int32_t time : scan.times_ns) {  // minmax_element() goes one by one
    interval.first = std::min(interval.first, time);
    interval.last = std::max(interval.last, time);
  }
  return interval;
}

/// Whether stamp and times add up within 64 bits.
std::string check_stamp(const Scan& scan, const Interval& interval) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (scan.stamp_ns <= Limits::max() - std::max(interval.last, 0) &&
      scan.stamp_ns >= Limits::min() - std::min(interval.first, 0)) {
    return {};
  }
  return "scan's stamp is " + std::to_string(scan.stamp_ns) +
         " ns; with its points' times it leaves the range of 64 bits";
}

/// Those of the values that are of valid points; none of none.
template <typename T>
std::vector<T> chosen(const std::vector<T>& values, const std::vector<std::uint32_t>& valid) {
  if (values.size() <= valid.size()) return values;
  std::vector<T> kept;
  kept.reserve(valid.size());
  for (const std::uint32_t i : valid) kept.push_back(values[i]);
  return kept;
}

/// All points equal (a driver's zero-filled message, say) tell nothing.
std::string check_extent(const PreparedScan& prepared, double min_extent) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : prepared.points) box.extend(point);
  const double diagonal = static_cast<double>(norm(box.diagonal()));
  if (diagonal >= min_extent) return {};
  return "scan's points lie within " + std::to_string(diagonal) +
         " m; expected an extent of at least " + std::to_string(min_extent) + " m";
}

}  // namespace

PreparedScan preprocess(const Scan& scan, const Config::Preprocess& config) {
  PreparedScan prepared;
  prepared.start_ns = prepared.end_ns = scan.stamp_ns;  // until the points' times tell better
  prepared.rejection = check_sizes(scan);
  const Interval interval = interval_of(scan);
  if (prepared.rejection.empty()) prepared.rejection = check_stamp(scan, interval);
  if (!prepared.rejection.empty()) return prepared;
  prepared.start_ns = scan.stamp_ns + interval.first;
  prepared.end_ns = scan.stamp_ns + interval.last;

  const auto duration = static_cast<double>(prepared.end_ns - prepared.start_ns);
  const bool timed = duration > 0.0;  // all times equal: nothing to deskew
  const double near = config.min_range * config.min_range;
  const double far = config.max_range * config.max_range;
  std::vector<std::uint32_t> valid;
  valid.reserve(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const double range2 = scan.points[i].cast<double>().squaredNorm();
    if (!(range2 >= near && range2 <= far) || !is_return(range2)) continue;  // NaN fails here too
    valid.push_back(static_cast<std::uint32_t>(i));
  }
  prepared.points = chosen(scan.points, valid);
  prepared.intensities = chosen(scan.intensities, valid);
  prepared.rings = chosen(scan.rings, valid);
  if (timed) {
    prepared.taus.reserve(valid.size());
    for (const std::uint32_t i : valid) {  // [Eq 1]
      const auto since_start =
          static_cast<double>(scan.stamp_ns + scan.times_ns[i] - prepared.start_ns);
      prepared.taus.push_back(static_cast<float>(since_start / duration));
    }
  }

  if (prepared.points.size() < static_cast<std::size_t>(config.min_points)) {
    prepared.rejection = "scan has " + std::to_string(prepared.points.size()) +
                         " valid points of " + std::to_string(scan.points.size()) +
                         "; expected at least " + std::to_string(config.min_points);
  } else {
    prepared.rejection = check_extent(prepared, config.min_extent);
  }
  return prepared;
}

}  // namespace surefoot
