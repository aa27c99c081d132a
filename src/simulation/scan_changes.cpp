// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scan_changes.hpp"

#include <algorithm>
#include <utility>

#include "simulation/random.hpp"

namespace surefoot::simulation {

std::int64_t middle_of(const Scan& scan) {
  if (scan.times_ns.empty()) return scan.stamp_ns;
  const auto [low, high] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
  return scan.stamp_ns + *low + (std::int64_t{*high} - *low) / 2;
}

Change at_later_stamps(std::int64_t shift_ns) {
  return [=](Scan& scan, std::uint64_t) { scan.stamp_ns += shift_ns; };
}

namespace {

/// Keeps the points for which `keep` holds.
void keep_points(Scan& scan, const Keep& keep) {
  Scan kept;
  kept.stamp_ns = scan.stamp_ns;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!keep(scan.points[i], i)) continue;
    kept.points.push_back(scan.points[i]);
    if (!scan.intensities.empty()) kept.intensities.push_back(scan.intensities[i]);
    if (!scan.times_ns.empty()) kept.times_ns.push_back(scan.times_ns[i]);
    if (!scan.rings.empty()) kept.rings.push_back(scan.rings[i]);
  }
  scan = std::move(kept);
}

}  // namespace

Change only(Keep keep) {
  return [=](Scan& scan, std::uint64_t) { keep_points(scan, keep); };
}

Change every_point(float value) {
  return [=](Scan& scan, std::uint64_t) {
    for (Eigen::Vector3f& p : scan.points) p.setConstant(value);
  };
}

Change scaled(float factor) {
  return [=](Scan& scan, std::uint64_t) {
    for (Eigen::Vector3f& p : scan.points) p *= factor;
  };
}

Change covered(float distance) {
  return [=](Scan& scan, std::uint64_t n) {
    const CounterRandom random(n, 71);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const float noise = 0.01F * static_cast<float>(random.normal(i));
      scan.points[i] *= (distance + noise) / scan.points[i].norm();
    }
  };
}

Change garbage(double share) {
  return [=](Scan& scan, std::uint64_t n) {
    const CounterRandom random(n, 72);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (random.uniform(2 * i) >= share) continue;
      const auto range = static_cast<float>(random.uniform(2 * i + 1, 1.0, 40.0));
      scan.points[i] *= range / scan.points[i].norm();
    }
  };
}

Change noisy(double sigma) {
  return [=](Scan& scan, std::uint64_t n) {
    const CounterRandom random(n, 73);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const auto noise = static_cast<float>(sigma * random.normal(i));
      scan.points[i] *= 1.0F + noise / scan.points[i].norm();
    }
  };
}

void tube(Scan& scan, std::uint64_t n) {
  const CounterRandom random(n, 74);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    Eigen::Vector3f& p = scan.points[i];
    const float across = std::max(p.tail<2>().norm(), 0.05F * p.norm());
    p *= (1.5F + 0.01F * static_cast<float>(random.normal(i))) / across;
  }
}

void floor_only(Scan& scan, std::uint64_t n) {
  const CounterRandom random(n, 75);
  keep_points(scan,
              [](const Eigen::Vector3f& p, std::size_t) { return p.z() < -0.02F * p.norm(); });
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    Eigen::Vector3f& p = scan.points[i];
    p *= (0.5F + 0.005F * static_cast<float>(random.normal(i))) / -p.z();
  }
}

void doubled(Scan& scan, std::uint64_t) {
  const auto twice = [](auto& values) {
    const auto once = values;
    values.insert(values.end(), once.begin(), once.end());
  };
  twice(scan.points);
  twice(scan.intensities);
  twice(scan.times_ns);
  twice(scan.rings);
}

void reversed_order(Scan& scan, std::uint64_t) {
  std::reverse(scan.points.begin(), scan.points.end());
  std::reverse(scan.intensities.begin(), scan.intensities.end());
  std::reverse(scan.times_ns.begin(), scan.times_ns.end());
  std::reverse(scan.rings.begin(), scan.rings.end());
}

void reversed_times(Scan& scan, std::uint64_t) {
  if (scan.times_ns.empty()) return;
  const auto [low, high] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
  const std::int64_t sum = std::int64_t{*low} + *high;
  for (std::int32_t& t : scan.times_ns) t = static_cast<std::int32_t>(sum - t);
}

void without_times(Scan& scan, std::uint64_t) {
  scan.stamp_ns = middle_of(scan);
  scan.times_ns.clear();
}

void mirrored(Scan& scan, std::uint64_t) {
  for (Eigen::Vector3f& p : scan.points) p.y() = -p.y();
}

}  // namespace surefoot::simulation
