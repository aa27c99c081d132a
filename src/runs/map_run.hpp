// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a run writes beside its own files where loops are closed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "mapping/map_builder.hpp"
#include "mapping/mapper.hpp"
#include "runs/map_outcome.hpp"
#include "runs/placed_scans.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

class MapRun {
 public:
  /// @param truth of the LiDAR's poses, to judge the loops by; may be empty.
  MapRun(const mapping::MapperOptions& options, Trajectory truth)
      : options_(options), mapper_(options), truth_(std::move(truth)) {}

  /// A scan whose pose was measured.
  void add(const Estimate& estimate, const DeskewedScan& scan);
  /// Closes the loops and writes trajectory_optimized.tum, loops.csv, pose_graph.g2o and, unless
  /// the map is empty, map_optimized.ply. `measured`: trajectory.tum's poses. `save`: also the map
  /// to come back to.
  MapOutcome finish(const std::filesystem::path& folder, const Trajectory& measured,
                    mapping::MapBuilder map, bool save);

  [[nodiscard]] const mapping::Mapper& mapper() const { return mapper_; }

 private:
  mapping::MapperOptions options_;
  mapping::Mapper mapper_;
  Trajectory truth_;
  PlacedScans placed_;
  std::optional<std::int64_t> first_stamp_ns_;
};

}  // namespace surefoot::runs
