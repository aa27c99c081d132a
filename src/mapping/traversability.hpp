// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a legged robot can stand and step: of the ground's heights, cell by cell.
#pragma once

#include <vector>

#include "mapping/grid_map.hpp"

namespace surefoot::mapping {

/// What stops the robot; by default a Unitree Go2.
struct LeggedRobot {
  double radius = 0.35;          ///< of the disc that its body covers [m]
  double most_slope_deg = 30.0;  ///< [deg]
  double most_step = 0.16;       ///< [m]
  double most_roughness = 0.05;  ///< [m]
};

/// Of each cell, over the disc about it. NaN where less than half of the disc has been seen.
struct Traversability {
  std::vector<float> slope;      ///< of the plane through the heights [rad]
  std::vector<float> step;       ///< the highest within two cells, beyond what the ground rises [m]
  std::vector<float> roughness;  ///< root mean square off the plane [m]
  /// 1 - max(slope / most, step / most, roughness / most), 0 at least: 1 is flat, 0 is a wall.
  std::vector<float> score;
};

[[nodiscard]] Traversability draw_traversability(const ElevationGrid& grid,
                                                 const LeggedRobot& robot);

}  // namespace surefoot::mapping
