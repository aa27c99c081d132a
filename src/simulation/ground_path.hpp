// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The way over the ground: where the body's support is after s metres of walking.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "simulation/cubic_bspline.hpp"
#include "simulation/motion.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"

namespace surefoot::simulation {

/// Where the feet stand in the body's frame, and how far a foothold is averaged along the way.
struct Stance {
  double half_length = 0.19;    ///< hip to body's centre [m]; Unitree Go2: 0.1934
  double half_width = 0.14;     ///< foot to body's centre line [m]; Unitree Go2: 0.0465 + 0.0955
  double foothold_blur = 0.12;  ///< standard deviation of the ground's smoothing under a foot [m]
};

/// The plane through the four footholds, as a smooth function of the distance walked.
class GroundPath {
 public:
  /// Walks the scene's route round and round until `length` metres are covered, at least one lap.
  /// @throws std::invalid_argument for a route of fewer than three corners, one that is not finite,
  /// shorter than 1 m or longer than 100 km, and where there is no ground under it.
  GroundPath(const Scene& scene, const RayCaster& rays, const Stance& stance, double length);

  [[nodiscard]] double length() const { return spline_.end(); }
  /// Length of one lap [m].
  [[nodiscard]] double lap() const { return lap_; }
  /// Centre of the footholds and the angles of their plane, after `distance` metres.
  [[nodiscard]] PoseAngles at(double distance) const { return spline_(distance); }

 private:
  CubicBSpline<6> spline_;
  double lap_ = 0.0;
};

}  // namespace surefoot::simulation
