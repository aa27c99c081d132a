// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "knots/knot_window.hpp"

namespace surefoot {

Twist difference(const Pose& pose, const Pose& from) {
  Twist result;
  result << pose.translation - from.translation, so3_log(pose.rotation * from.rotation.conjugate());
  return result;
}

Pose displaced(const Pose& pose, const Twist& by) {
  return {(so3_exp(by.tail<3>()) * pose.rotation).normalized(), pose.translation + by.head<3>()};
}

Twist KnotWindow::velocity(std::size_t from_knot) const {
  return difference(knots[from_knot + 1], knots[from_knot]) / duration(from_knot);
}

Twist KnotWindow::mean_velocity() const {
  return difference(knots.back(), knots[1]) / (static_cast<double>(segments()) * step);
}

ScanTrajectory KnotWindow::trajectory() const {
  return ScanTrajectory(std::vector<Pose>(knots.begin() + 1, knots.end()), begin_ns, end_ns);
}

}  // namespace surefoot
