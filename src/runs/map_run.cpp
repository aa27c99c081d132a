// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/file_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "mapping/g2o_file.hpp"
#include "runs/loop_truth.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

void MapRun::add(const Estimate& estimate, const DeskewedScan& scan) {
  if (!first_stamp_ns_) first_stamp_ns_ = estimate.stamp_ns;
  mapper_.add(placed_.next(estimate), scan);
}

MapOutcome MapRun::finish(const std::filesystem::path& folder, const Trajectory& measured,
                          mapping::MapBuilder map, bool save) {
  mapper_.finish();
  MapOutcome outcome;
  outcome.pieces = mapper_.pieces().size();
  outcome.candidates = mapper_.loops().size();
  outcome.taken = mapper_.taken();
  Trajectory corrected = measured;
  for (StampedPose& pose : corrected) {
    const Pose moved = mapper_.correction(pose.stamp_ns) * pose.pose;
    outcome.moved = std::max(outcome.moved, (moved.translation - pose.pose.translation).norm());
    pose.pose = moved;
  }
  std::optional<LoopTruth> truth;
  if (!truth_.empty()) {
    truth = judge_loops(mapper_, truth_, options_.loops.way_between);
    outcome.score = truth->score();
    io::write_whole_file(folder / kRevisitsFile, revisits_csv(mapper_, *truth));
  }
  io::write_tum(folder / kOptimizedTrajectoryFile, corrected);
  io::write_whole_file(folder / kLoopsFile, loops_csv(mapper_, truth ? &*truth : nullptr));
  io::write_whole_file(folder / kPoseGraphFile, mapping::format_g2o(mapper_.graph()));
  if (save) write_saved_map(folder / kSavedMapFile, saved_map_of(mapper_));
  if (map.points().empty()) return outcome;
  map.correct([this](double time) {
    return mapper_.correction(first_stamp_ns_.value_or(0) + std::llround(1e9 * time));
  });
  const std::vector<io::PlyColumn> columns = {{"intensity", map.intensities()},
                                              {"first_seen", map.first_seen()}};
  io::write_ply(folder / kOptimizedMapFile, map.points(), columns);
  return outcome;
}

}  // namespace surefoot::runs
