// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a run writes beside its own files where loops are closed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "mapping/finished_walk.hpp"
#include "mapping/map_builder.hpp"
#include "mapping/map_file.hpp"
#include "mapping/placed_scans.hpp"
#include "mapping/walk_mapper.hpp"
#include "report/run_picture.hpp"
#include "runs/loop_truth.hpp"
#include "runs/map_outcome.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

class MapRun {
 public:
  /// @param truth of the LiDAR's poses, to judge the loops by; may be empty.
  /// @param continued a map that this run's is to be joined to; none: it stands by itself.
  MapRun(const mapping::MapperOptions& options, Trajectory truth,
         std::optional<mapping::SavedMap> continued = {})
      : options_(options),
        mapper_(options),
        truth_(std::move(truth)),
        continued_(std::move(continued)) {}

  /// A scan whose pose was measured. `T_lidar_written` as for the run's trajectories. Pieces of
  /// way and poses are kept, so that memory grows with the run.
  void add(const Estimate& estimate, const Pose& T_lidar_written, const DeskewedScan& scan);
  /// Closes the loops and writes trajectory_optimized.tum, loops.csv, pose_graph.g2o and, unless
  /// the map is empty, map_optimized.ply. `save`: also the map to come back to. Where a map is
  /// continued all of that is in its frame; where it cannot be, the run's own map is written as
  /// map_apart.surefoot. Throws io::WriteError.
  MapOutcome finish(const std::filesystem::path& folder, const mapping::MapBuilder& map, bool save);

  /// The loops as a picture shows them, in the run's own frame; after finish().
  [[nodiscard]] report::DrawnLoops drawn() const;

  [[nodiscard]] const mapping::WalkMapper& mapper() const { return mapper_; }

 private:
  [[nodiscard]] std::optional<LoopTruth> judged(MapOutcome& outcome) const;
  [[nodiscard]] Trajectory corrected() const;
  void join(const std::filesystem::path& folder, mapping::FinishedWalk& walk, MapOutcome& outcome);
  void write_points(const std::filesystem::path& folder, const mapping::FinishedWalk& walk,
                    const mapping::MapBuilder& map) const;

  mapping::MapperOptions options_;
  mapping::WalkMapper mapper_;
  Trajectory truth_;
  std::optional<mapping::SavedMap> continued_;
  mapping::PlacedScans scans_;
  Trajectory measured_;  ///< what trajectory.tum holds, to the last bit
  mapping::WalkClock clock_;
};

}  // namespace surefoot::runs
