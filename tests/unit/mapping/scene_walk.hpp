// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A walk through a simulated scene, scan by scan, with an odometry that goes astray as told: what a
// mapper gets, without the seconds that an odometry takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mapping/piece.hpp"

namespace surefoot::test {

struct SceneWalk {
  std::vector<mapping::PlacedScan> scans;
  std::vector<DeskewedScan> points;
  std::vector<Pose> truth;  ///< T_world_lidar, one a scan
};

struct WalkOptions {
  double from = 0.0;           ///< on the route [m]
  double length = 100.0;       ///< [m]; the route is walked round and round
  double step = 0.25;          ///< between scans [m]
  double yaw_drift = 0.0;      ///< of the odometry [rad/m]
  double rise = 0.0;           ///< of the odometry [m/m]
  bool unknown_start = false;  ///< the odometry's world begins at the first pose
  std::uint64_t things = 0;    ///< seed of what stands about; 0: the layout's
};

[[nodiscard]] SceneWalk walk_through(const std::string& scene, std::uint64_t seed,
                                     const WalkOptions& options);

}  // namespace surefoot::test
