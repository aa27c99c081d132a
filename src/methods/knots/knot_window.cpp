// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surefoot/seconds.hpp"

namespace surefoot {

Twist difference(const Pose& pose, const Pose& from) {
  Twist result;
  result << pose.translation - from.translation, so3_log(pose.rotation * from.rotation.conjugate());
  return result;
}

Pose displaced(const Pose& pose, const Twist& by) {
  return {(so3_exp(by.tail<3>()) * pose.rotation).normalized(), pose.translation + by.head<3>()};
}

Twist rotated(const Eigen::Quaterniond& rotation, const Twist& twist) {
  Twist turned;
  turned << rotation * twist.head<3>(), rotation * twist.tail<3>();
  return turned;
}

Twist alike(const Twist& v) {
  Twist shared = v;
  shared[0] = shared[1] = 0.5 * (v[0] + v[1]);
  shared[3] = shared[4] = 0.5 * (v[3] + v[4]);
  return shared;
}

std::pair<std::size_t, double> KnotWindow::place_of(std::int64_t instant_ns) const {
  const double steps = seconds(instant_ns - begin_ns) / step;
  const auto last = static_cast<double>(segments() - 1);
  const auto segment = static_cast<std::size_t>(std::clamp(steps, 0.0, last));
  return {segment + 1, std::clamp(steps - static_cast<double>(segment), 0.0, 1.0)};
}

Twist KnotWindow::velocity(std::size_t from_knot) const {
  return difference(knots[from_knot + 1], knots[from_knot]) / duration(from_knot);  // [K5]
}

KnotWindow KnotWindow::at_velocity(const Twist& velocity) const {
  return moved_on(1, velocity, Twist::Zero());
}

KnotWindow KnotWindow::going_on_after(std::size_t segment, bool changing) const {
  const Twist own = velocity(segment + 1);
  if (!changing) return moved_on(segment + 2, own, Twist::Zero());
  const Twist change = own - velocity(segment);
  return moved_on(segment + 2, own + change, change);
}

KnotWindow KnotWindow::moved_on(std::size_t from_knot, Twist velocity, const Twist& change) const {
  KnotWindow moved = *this;
  for (std::size_t k = from_knot + 1; k < knots.size(); ++k) {
    moved.knots[k] = displaced(moved.knots[k - 1], step * velocity);
    velocity += change;
  }
  return moved;
}

Twist KnotWindow::mean_velocity() const {
  return difference(knots.back(), knots[1]) / (static_cast<double>(segments()) * step);
}

ScanTrajectory KnotWindow::trajectory() const {
  return ScanTrajectory(std::vector<Pose>(knots.begin() + 1, knots.end()), begin_ns, end_ns);
}

ScanTrajectory KnotWindow::trajectory(std::int64_t from_ns, std::int64_t until_ns) const {
  const ScanTrajectory whole = trajectory();
  std::vector<Pose> poses;
  for (std::size_t k = 0; k <= segments(); ++k) {
    const double tau = static_cast<double>(k) / static_cast<double>(segments());
    const double since = tau * static_cast<double>(until_ns - from_ns);
    poses.push_back(whole.at_time(from_ns + static_cast<std::int64_t>(std::llround(since))));
  }
  return ScanTrajectory(std::move(poses), from_ns, until_ns);
}

}  // namespace surefoot
