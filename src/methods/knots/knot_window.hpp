// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "surefoot/scan_trajectory.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// The poses that one scan's registration estimates ("knots"): the last two of the scan before,
/// then one at the end of each segment of the new scan. Between two knots the velocity is
/// constant.
struct KnotWindow {
  std::vector<Pose> knots;    ///< T_map_lidar
  double first_step = 0.0;    ///< [s] from knots[0] to knots[1]
  double step = 0.0;          ///< [s] between all others
  std::int64_t begin_ns = 0;  ///< of knots[1]
  std::int64_t end_ns = 0;    ///< of knots.back()

  /// Segments of the new scan: segment s lies between knots s + 1 and s + 2.
  [[nodiscard]] std::size_t segments() const { return knots.size() - 2; }
  [[nodiscard]] double duration(std::size_t from_knot) const {
    return from_knot == 0 ? first_step : step;
  }
  /// The knot of the new scan before an instant, and the share of the way to the next.
  [[nodiscard]] std::pair<std::size_t, double> place_of(std::int64_t instant_ns) const;
  /// Velocity from a knot to the next, in the map's axes [m/s, rad/s].
  [[nodiscard]] Twist velocity(std::size_t from_knot) const;
  /// The new scan's knots moved on at one velocity.
  [[nodiscard]] KnotWindow at_velocity(const Twist& velocity) const;
  /// Likewise those of them after a segment, at its own velocity; or, `changing`, at one that goes
  /// on changing as it did from the segment before to this one.
  [[nodiscard]] KnotWindow going_on_after(std::size_t segment, bool changing) const;
  /// Mean velocity over the new scan, likewise.
  [[nodiscard]] Twist mean_velocity() const;
  /// The new scan's motion.
  [[nodiscard]] ScanTrajectory trajectory() const;
  /// The part of it between two instants, with as many segments.
  [[nodiscard]] ScanTrajectory trajectory(std::int64_t from_ns, std::int64_t until_ns) const;

 private:
  /// The knots after one, the velocity changing by so much from each step to the next.
  [[nodiscard]] KnotWindow moved_on(std::size_t from_knot, Twist velocity,
                                    const Twist& change) const;
};

/// How far one pose is from another: translation in the map's axes [m], rotation about the sensor
/// in the map's axes [rad].
[[nodiscard]] Twist difference(const Pose& pose, const Pose& from);

/// A pose moved by such a difference.
[[nodiscard]] Pose displaced(const Pose& pose, const Twist& by);

/// A velocity or difference in other axes.
[[nodiscard]] Twist rotated(const Eigen::Quaterniond& rotation, const Twist& twist);

/// Axes that are alike however the x axis lies share one value: x and y, roll and pitch.
[[nodiscard]] Twist alike(const Twist& v);

}  // namespace surefoot
