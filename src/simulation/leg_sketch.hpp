// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Legs for pictures. The simulation itself has none: the body follows the ground by a formula.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "simulation/body_motion.hpp"
#include "simulation/ray_caster.hpp"

namespace surefoot::simulation {

/// One leg in the map [m].
struct Leg {
  Eigen::Vector3d hip;
  Eigen::Vector3d knee;
  Eigen::Vector3d foot;
};

/// Feet that touch down when the gait's impacts come, below where their hips are at mid-stance.
class LegSketch {
 public:
  /// @param gait, seed as given to make_motion. @param motion, rays must outlive the sketch.
  LegSketch(const GaitModel& gait, const Motion& motion, const RayCaster& rays, std::uint64_t seed);

  /// Front left, front right, rear right, rear left. @param T_map_body where the hips are; the feet
  /// keep to the motion. Empty for what has no legs.
  [[nodiscard]] std::vector<Leg> at(double time, const Pose& T_map_body) const;

 private:
  [[nodiscard]] double phase_at(double time) const;
  [[nodiscard]] double time_of(double phase) const;
  [[nodiscard]] Eigen::Vector3d foothold(std::size_t leg, double step) const;
  [[nodiscard]] Eigen::Vector3d foot_at(std::size_t leg, double time) const;
  [[nodiscard]] double touchdown(std::size_t leg) const;

  GaitModel gait_;
  const Motion* motion_;
  const RayCaster* rays_;
  std::vector<double> phases_;  ///< strides done, every kMotionStep from one step before time 0
  double stance_ = 0.5;         ///< share of the stride that a foot stands
};

}  // namespace surefoot::simulation
