// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/scan_facts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include "geometry/returns.hpp"
#include "surefoot/quantile.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::checks {
namespace {

constexpr std::size_t kDirections = 180;
constexpr double kStepDeg = 360.0 / static_cast<double>(kDirections);
// Legged robots turn by less from scan to scan.
constexpr int kMostSteps = 20;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
// Of a scan's returns, for its middle range.
constexpr std::size_t kSample = 4000;

std::size_t direction_of(const Eigen::Vector3f& point) {
  const double turn = std::atan2(static_cast<double>(point.y()), static_cast<double>(point.x())) /
                      (2.0 * std::numbers::pi);
  const auto step = static_cast<std::size_t>((turn + 0.5) * static_cast<double>(kDirections));
  return std::min(step, kDirections - 1);
}

/// How far the surroundings are, direction by direction.
std::vector<double> profile_of(const Scan& scan) {
  std::vector<double> sums(kDirections, 0.0), counts(kDirections, 0.0);
  for (const Eigen::Vector3f& point : scan.points) {
    const double range = point.cast<double>().norm();
    if (!is_return(point)) continue;
    const std::size_t k = direction_of(point);
    sums[k] += std::log(range);
    counts[k] += 1.0;
  }
  for (std::size_t k = 0; k < kDirections; ++k) {
    sums[k] = counts[k] > 0.0 ? sums[k] / counts[k] : kNothing;
  }
  return sums;
}

// Mean square difference of two profiles, the second turned by so many steps.
double mismatch(const std::vector<double>& a, const std::vector<double>& b, int steps) {
  double sum = 0.0, count = 0.0;
  for (int k = 0; k < static_cast<int>(kDirections); ++k) {
    const int turned = (k + steps + static_cast<int>(kDirections)) % static_cast<int>(kDirections);
    const double difference = a[static_cast<std::size_t>(k)] - b[static_cast<std::size_t>(turned)];
    if (!std::isfinite(difference)) continue;
    sum += difference * difference;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : kNothing;
}

/// The turn under which one profile looks most like the other, between steps by a parabola.
double turn_between(const std::vector<double>& before, const std::vector<double>& now) {
  if (before.empty()) return 0.0;
  int best = 0;
  double least = mismatch(now, before, 0);
  for (int steps = -kMostSteps; steps <= kMostSteps; ++steps) {
    const double value = mismatch(now, before, steps);
    if (!(value < least)) continue;
    least = value;
    best = steps;
  }
  const double left = mismatch(now, before, best - 1), right = mismatch(now, before, best + 1);
  const double bend = left - 2.0 * least + right;
  const double offset = bend > 0.0 ? 0.5 * (left - right) / bend : 0.0;
  return (static_cast<double>(best) + std::clamp(offset, -0.5, 0.5)) * kStepDeg;
}

void look_at_ranges(const Scan& scan, ScanFacts& facts) {
  std::vector<double> ranges;
  Eigen::AlignedBox3f returns;
  for (const Eigen::Vector3f& point : scan.points) {
    const double range = point.cast<double>().norm();
    if (!std::isfinite(range)) {
      ++facts.not_finite;
    } else if (range < kNoRange) {
      ++facts.zero;
    } else {
      ranges.push_back(range);
      returns.extend(point);
    }
  }
  facts.returns = ranges.size();
  if (ranges.empty()) return;
  facts.at_one_height = ranges.size() > 1 && returns.sizes().z() == 0.0F;
  const auto [least, greatest] = std::minmax_element(ranges.begin(), ranges.end());
  facts.nearest = *least;
  facts.farthest = *greatest;
  std::vector<double> sample;
  for (std::size_t i = 0; i < ranges.size(); i += ranges.size() / kSample + 1) {
    sample.push_back(ranges[i]);
  }
  facts.middle = quantile(std::move(sample), 0.5);
}

void look_at_times(const Scan& scan, ScanFacts& facts) {
  facts.times = io::point_times_of(scan);
  if (scan.times_ns.empty()) return;
  const auto [least, greatest] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
  facts.first_s = seconds(*least);
  facts.last_s = seconds(*greatest);
  facts.spin = io::spin_of(scan);
}

std::vector<std::uint16_t> rings_of(const Scan& scan) {
  std::vector<bool> seen;
  for (std::size_t i = 0; i < scan.rings.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    if (!is_return(point)) continue;
    if (scan.rings[i] >= seen.size()) seen.resize(scan.rings[i] + std::size_t{1});
    seen[scan.rings[i]] = true;
  }
  std::vector<std::uint16_t> rings;
  for (std::size_t ring = 0; ring < seen.size(); ++ring) {
    if (seen[ring]) rings.push_back(static_cast<std::uint16_t>(ring));
  }
  return rings;
}

}  // namespace

ScanFacts ScanLooker::look(const io::ScanItem& item) {
  ScanFacts facts;
  facts.name = item.name;
  facts.remark = item.remark;
  if (!item.scan) {
    facts.error = item.error.empty() ? "cannot be read" : item.error;
    return facts;
  }
  const Scan& scan = *item.scan;
  facts.stamp_ns = scan.stamp_ns;
  facts.logged_ns = item.logged_ns;
  facts.clock = item.clock;
  facts.points = scan.points.size() + item.dropped_not_finite + item.dropped_zero;
  facts.not_finite = item.dropped_not_finite;
  facts.zero = item.dropped_zero;
  facts.untimed = item.dropped_points;
  look_at_ranges(scan, facts);
  look_at_times(scan, facts);
  facts.rings = rings_of(scan);
  std::vector<double> profile = profile_of(scan);
  const auto seen = std::count_if(profile.begin(), profile.end(),
                                  [](double value) { return std::isfinite(value); });
  facts.seen_around = static_cast<double>(seen) / static_cast<double>(kDirections);
  facts.turned_deg = turn_between(profile_, profile);
  profile_ = std::move(profile);
  const std::uint64_t points = facts.returns == 0 ? 0 : io::number_of(scan.points);
  const bool came_before = seen_.came_before(scan);
  facts.sent_again = points != 0 && (came_before || points == last_points_);
  last_points_ = points;
  return facts;
}

}  // namespace surefoot::checks
