// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the benchmarks are fed with: a VLP-16 carried through a simulated scene, scan by scan.
#pragma once

#include <cstdint>
#include <optional>

#include "simulation/ray_caster.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene.hpp"
#include "surefoot/pose.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::benchmarks {

struct WalkOptions {
  std::uint64_t scans = 0;
  double speed = 0.0;     ///< [m/s]; 0: the gait's own
  bool footprint = true;  ///< several rays a beam; false is faster
};

/// A robot on its way. Equal scenes and options give equal scans.
class SimulatedWalk {
 public:
  SimulatedWalk(simulation::Scene scene, const WalkOptions& options);
  SimulatedWalk(const SimulatedWalk&) = delete;  // the scanner looks into rays_
  SimulatedWalk& operator=(const SimulatedWalk&) = delete;

  /// The next scan, or nothing at the end.
  [[nodiscard]] std::optional<Scan> next();
  /// Where the LiDAR truly is [m, scene's frame] at an instant of the scans' clock.
  [[nodiscard]] Pose T_map_lidar(std::int64_t instant_ns) const;

 private:
  simulation::Scene scene_;
  std::uint64_t scans_;
  std::uint64_t done_ = 0;
  simulation::RayCaster rays_;
  simulation::Scanner scanner_;
};

/// Scene of the recording that `surefoot simulate campus` makes.
[[nodiscard]] simulation::Scene campus();

}  // namespace surefoot::benchmarks
