// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_run.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/file_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/trajectory_files.hpp"
#include "mapping/g2o_file.hpp"
#include "runs/loop_truth.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

namespace {

/// The poses with a mark where those of another frame begin, as trajectory.tum has them.
std::string marked(const std::vector<mapping::FramePoses>& frames) {
  std::string text;
  std::size_t frame = 0;
  for (const mapping::FramePoses& part : frames) {
    if (part.frame != frame) text += segment_mark(part.frame);
    frame = part.frame;
    text += io::format_tum(part.poses);
  }
  return text;
}

}  // namespace

void MapRun::add(const Estimate& estimate, const Pose& T_lidar_written, const DeskewedScan& scan) {
  (void)clock_.next(estimate.stamp_ns);
  measured_.push_back({estimate.stamp_ns, estimate.T_world_lidar * T_lidar_written});
  mapper_.add(scans_.next(estimate), scan);
}

MapOutcome MapRun::finish(const std::filesystem::path& folder, const mapping::MapBuilder& map,
                          bool save) {
  mapper_.finish();
  MapOutcome outcome;
  outcome.pieces = mapper_.pieces().size();
  outcome.candidates = mapper_.loops().size();
  outcome.taken = mapper_.taken();
  const Trajectory moved = corrected();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Eigen::Vector3d by = moved[i].pose.translation - measured_[i].pose.translation;
    outcome.moved = std::max(outcome.moved, by.norm());
  }
  const std::optional<LoopTruth> truth = judged(outcome);
  if (truth) io::write_whole_file(folder / kRevisitsFile, revisits_csv(mapper_, *truth));
  io::write_whole_file(folder / kLoopsFile,
                       loops_csv(mapper_.pieces(), mapper_.loops(), truth ? &*truth : nullptr));
  mapping::FinishedWalk walk(mapper_);
  walk.drop_moved();
  if (continued_) join(folder, walk, outcome);
  const bool apart = outcome.join && !outcome.join->joined;
  if (save) write_saved_map(folder / (apart ? kApartMapFile : kSavedMapFile), walk.map());
  io::write_whole_file(folder / kOptimizedTrajectoryFile, marked(walk.corrected(measured_)));
  const mapping::PoseGraph graph = outcome.join ? walk.graph() : mapper_.graph();
  io::write_whole_file(folder / kPoseGraphFile, mapping::format_g2o(graph));
  if (!map.points().empty()) write_points(folder, walk, map);
  return outcome;
}

/// The loops held against the truth, if there is one. That it is of another time, or ends before
/// the recording does, is no reason to have no map.
std::optional<LoopTruth> MapRun::judged(MapOutcome& outcome) const {
  if (truth_.empty()) return std::nullopt;
  try {
    LoopTruth truth = judge_loops(mapper_, truth_, options_.loops.way_between);
    outcome.score = truth.score();
    return truth;
  } catch (const std::exception& error) {
    outcome.unjudged = error.what();
    return std::nullopt;
  }
}

/// What was measured, moved by the run's own loops.
Trajectory MapRun::corrected() const {
  Trajectory result;
  mapping::WalkClock clock;
  for (const StampedPose& pose : measured_) {
    const Pose T_map_odometry = mapper_.correction(clock.next(pose.stamp_ns));
    result.push_back({pose.stamp_ns, T_map_odometry * pose.pose});
  }
  return result;
}

void MapRun::join(const std::filesystem::path& folder, mapping::FinishedWalk& walk,
                  MapOutcome& outcome) {
  const mapping::MapJoin join = walk.join(*continued_);
  io::write_whole_file(folder / kMapLoopsFile, join_csv_header() + join_csv(join, 2));
  outcome.join = {join.joint.has_value(),   join.loops.size(), join.taken,  join.comparison.near,
                  walk.map().pieces.size(), join.message,      join.begin()};
}

report::DrawnLoops MapRun::drawn() const {
  report::DrawnLoops drawn;
  const std::vector<mapping::Piece>& pieces = mapper_.pieces();
  for (const mapping::Loop& loop : mapper_.loops()) {
    const bool taken = mapping::is_taken(loop);
    (taken ? drawn.taken : drawn.refused)
        .emplace_back(pieces[loop.place].T_world_piece.translation,
                      pieces[loop.query].T_world_piece.translation);
  }
  drawn.corrected = corrected();
  return drawn;
}

void MapRun::write_points(const std::filesystem::path& folder, const mapping::FinishedWalk& walk,
                          const mapping::MapBuilder& map) const {
  using Correction = mapping::MapBuilder::Correction;
  const auto correction = [&](std::int64_t after_ns) -> std::optional<Correction> {
    const std::int64_t time_ns = clock_.begin_ns() + after_ns;
    const std::optional<Pose> T_map_odometry = walk.correction(time_ns);
    if (!T_map_odometry) return std::nullopt;
    return Correction{*T_map_odometry, walk.frame_at(time_ns)};
  };
  const mapping::MapBuilder moved = map.corrected(correction);
  std::vector<std::int64_t> times = moved.first_seen_ns();
  for (std::int64_t& time : times) time += clock_.begin_ns();
  const std::vector<bool> gone = walk.moved(moved.points(), times);
  std::vector<float> intensities, first_seen;
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (gone[i]) continue;
    points.push_back(moved.points()[i]);
    first_seen.push_back(moved.first_seen()[i]);
    if (!moved.intensities().empty()) intensities.push_back(moved.intensities()[i]);
  }
  const std::vector<io::PlyColumn> columns = {{"intensity", intensities},
                                              {"first_seen", first_seen}};
  io::write_ply(folder / kOptimizedMapFile, points, columns);
}

}  // namespace surefoot::runs
