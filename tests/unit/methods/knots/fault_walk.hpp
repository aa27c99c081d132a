// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A walk through the furnished hall that something happens to.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "support/synthetic_run.hpp"

namespace surefoot::test {

inline constexpr int kFaultScans = 45;
inline constexpr int kEvent = 20;
inline const Pose kFaultStart{Eigen::Quaterniond::Identity(), {-5.0, 0.5, 0.45}};

inline MotionFunction walk() {
  return constant_velocity(kFaultStart, (Twist() << 0.5, 0, 0, 0, 0, 0).finished());
}

inline const std::vector<Scan>& walk_scans() {
  static const std::vector<Scan> scans = take_scans(furnished_hall(), walk(), kFaultScans);
  return scans;
}

/// The walk, somewhere else from scan kEvent on.
inline MotionFunction carried(const Pose& by) {
  const MotionFunction motion = walk();
  const Pose before = motion(0.1 * kEvent);
  return [=](double t) {
    return t < 0.1 * kEvent ? motion(t) : before * by * before.inverse() * motion(t);
  };
}

inline void make_garbage(Scan& scan) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> range(1.0F, 15.0F);
  for (Eigen::Vector3f& point : scan.points) point *= range(random) / point.norm();
}

/// Nothing but a level floor.
inline void make_floor(Scan& scan) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::int32_t> times_ns;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& p = scan.points[i];
    if (p.z() >= -0.02F * p.norm()) continue;
    points.emplace_back(p * (-0.45F / p.z()));
    if (!scan.times_ns.empty()) times_ns.push_back(scan.times_ns[i]);
  }
  scan = {scan.stamp_ns, points, {}, times_ns, {}};
}

inline double distance(const Pose& a, const Pose& b) {
  return (a.translation - b.translation).norm();
}

/// [m] of an estimate against the first of its segment that the run has.
inline double end_error(const std::vector<Estimate>& all, const Estimate& last,
                        const MotionFunction& motion) {
  const auto first = std::find_if(all.begin(), all.end(), [&](const Estimate& e) {
    return e.trusted() && e.segment == last.segment;
  });
  const auto truth = [&](const Estimate& e) {
    return motion(1e-9 * static_cast<double>(e.stamp_ns));
  };
  return distance(first->T_world_lidar.inverse() * last.T_world_lidar,
                  truth(*first).inverse() * truth(last));
}

}  // namespace surefoot::test
