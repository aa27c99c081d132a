// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/file_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "mapping/g2o_file.hpp"
#include "mapping/map_merge.hpp"
#include "runs/loop_truth.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

void MapRun::add(const Estimate& estimate, const DeskewedScan& scan) {
  if (!first_stamp_ns_) first_stamp_ns_ = estimate.stamp_ns;
  mapper_.add(scans_.next(estimate), scan);
}

MapOutcome MapRun::finish(const std::filesystem::path& folder, const Trajectory& measured,
                          mapping::MapBuilder map, bool save) {
  mapper_.finish();
  MapOutcome outcome;
  outcome.pieces = mapper_.pieces().size();
  outcome.candidates = mapper_.loops().size();
  outcome.taken = mapper_.taken();
  for (const StampedPose& pose : measured) {
    const Pose moved = mapper_.correction(pose.stamp_ns) * pose.pose;
    outcome.moved = std::max(outcome.moved, (moved.translation - pose.pose.translation).norm());
  }
  std::optional<LoopTruth> truth;
  if (!truth_.empty()) {
    truth = judge_loops(mapper_, truth_, options_.loops.way_between);
    outcome.score = truth->score();
    io::write_whole_file(folder / kRevisitsFile, revisits_csv(mapper_, *truth));
  }
  io::write_whole_file(folder / kLoopsFile, loops_csv(mapper_, truth ? &*truth : nullptr));
  graph_ = mapper_.graph();
  poses_ = graph_.poses;
  placed_.assign(poses_.size(), true);
  if (save || continued_) saved_ = saved_map_of(mapper_);
  if (continued_) join(folder, outcome);
  const bool apart = outcome.join && !outcome.join->joined;
  if (save) write_saved_map(folder / (apart ? kApartMapFile : kSavedMapFile), saved_);
  io::write_tum(folder / kOptimizedTrajectoryFile, corrected(measured));
  io::write_whole_file(folder / kPoseGraphFile, mapping::format_g2o(graph_));
  if (!map.points().empty()) write_points(folder, std::move(map));
  return outcome;
}

void MapRun::join(const std::filesystem::path& folder, MapOutcome& outcome) {
  mapping::MapJoin join = mapping::join_maps(*continued_, saved_);
  io::write_whole_file(folder / kMapLoopsFile, join_csv_header() + join_csv(join, 2));
  outcome.join = {join.joint.has_value(),
                  join.loops.size(),
                  join.taken,
                  join.comparison.near,
                  join.joint ? join.joint->pieces.size() : 0,
                  join.message};
  if (!join.joint) return;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    placed_[i] = join.placed[i].has_value();
    if (placed_[i]) poses_[i] = *join.placed[i];
  }
  saved_ = std::move(*join.joint);
  graph_ = {};
  for (const mapping::Piece& piece : saved_.pieces) graph_.poses.push_back(piece.T_world_piece);
  graph_.edges = saved_.edges;
}

/// Without those of pieces that nothing holds to the map that is continued.
Trajectory MapRun::corrected(const Trajectory& measured) const {
  Trajectory result;
  const std::vector<mapping::Piece>& pieces = mapper_.pieces();
  for (const StampedPose& pose : measured) {
    const auto next = std::upper_bound(
        pieces.begin(), pieces.end(), pose.stamp_ns,
        [](std::int64_t stamp, const mapping::Piece& piece) { return stamp < piece.begin_ns; });
    const auto piece = std::max<std::ptrdiff_t>(next - pieces.begin() - 1, 0);
    if (!placed_.empty() && !placed_[static_cast<std::size_t>(piece)]) continue;
    result.push_back(
        {pose.stamp_ns, mapping::correction_at(pieces, poses_, pose.stamp_ns) * pose.pose});
  }
  return result;
}

void MapRun::write_points(const std::filesystem::path& folder, mapping::MapBuilder map) const {
  map.correct([this](double time) {
    return mapping::correction_at(mapper_.pieces(), poses_,
                                  first_stamp_ns_.value_or(0) + std::llround(1e9 * time));
  });
  const std::vector<io::PlyColumn> columns = {{"intensity", map.intensities()},
                                              {"first_seen", map.first_seen()}};
  io::write_ply(folder / kOptimizedMapFile, map.points(), columns);
}

}  // namespace surefoot::runs
