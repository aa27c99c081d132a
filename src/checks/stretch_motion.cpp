// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/stretch_motion.hpp"

#include <algorithm>
#include <numbers>

namespace surefoot::checks {

std::optional<StretchMotion> motion_along(const Trajectory& path) {
  constexpr double kStep = 0.1, kTurn = 2.0;  // [m], [deg]; estimates of who stands stay below
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  if (path.size() < 2) return std::nullopt;
  StretchMotion motion;
  Eigen::Vector3d place = path.front().pose.translation;
  Eigen::Quaterniond heading = path.front().pose.rotation;
  for (const StampedPose& pose : path) {
    const Eigen::Vector3d& at = pose.pose.translation;
    motion.reach_m = std::max(motion.reach_m, (at - path.front().pose.translation).norm());
    if (const double step = (at - place).norm(); step >= kStep) {
      motion.way_m += step;
      place = at;
    }
    const double turn = kDegrees * heading.angularDistance(pose.pose.rotation);
    if (turn < kTurn) continue;
    motion.turned_deg += turn;
    heading = pose.pose.rotation;
  }
  return motion;
}

}  // namespace surefoot::checks
