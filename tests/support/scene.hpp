// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A world of boxes and an analytic ray caster: exact distances for tests with exact truth.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "surefoot/pose.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::test {

/// A box in the world; rays that start inside see its inner walls, so a box is also a room.
struct Box {
  Pose T_world_box;
  Eigen::Vector3d half;  ///< half of its edges [m]
};

/// Box between two corners, edges along the world's axes.
[[nodiscard]] Box box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

class Scene {
 public:
  Scene& add(const Box& box);
  /// Distance to the first surface along a unit direction [m]; infinite if there is none.
  [[nodiscard]] double cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  /// The same scene elsewhere.
  [[nodiscard]] Scene moved(const Pose& T_new_old) const;

 private:
  std::vector<Box> boxes_;
};

/// A hall of 30 m x 20 m x 6 m, floor at z = 0, with a few boxes in it.
[[nodiscard]] Scene bare_hall();
/// The same hall with shelves and pillars along both sides.
[[nodiscard]] Scene furnished_hall();
/// Flat ground, a ramp of 10 m length and `slope_deg` that begins at x = 0, and a plateau behind
/// it, between walls and pillars 16 m apart.
[[nodiscard]] Scene ramp_yard(double slope_deg);

/// T_world_lidar at a time [s].
using MotionFunction = std::function<Pose(double)>;

/// A spinning scanner: 16 lasers from -15 to 15 degrees, every point with its own time.
struct Scanner {
  int columns = 360;          ///< per revolution; 16 points each
  double period = 0.1;        ///< [s]
  double max_range = 80.0;    ///< [m]
  double noise = 0.01;        ///< [m] standard deviation of a range
  bool point_times = true;    ///< false: the scan says nothing about its points' times
  std::int64_t epoch_ns = 0;  ///< stamp of time 0
};

/// One revolution that starts at `start` [s]; directions without a surface give a zero point.
[[nodiscard]] Scan take_scan(const Scene& scene, const MotionFunction& T_world_lidar, double start,
                             const Scanner& scanner);

}  // namespace surefoot::test
