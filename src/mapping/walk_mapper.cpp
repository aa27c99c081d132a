// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/walk_mapper.hpp"

#include <algorithm>

#include "mapping/loop_solution.hpp"
#include "mapping/stretches.hpp"

namespace surefoot::mapping {

namespace {

LoopOptions with_file(LoopOptions options, const std::filesystem::path& folder) {
  if (!options.clouds) options.clouds = CloudFile::make(folder);
  return options;
}

/// What moved is asked about once the walk is over.
PieceOptions with_things(PieceOptions options) {
  options.things = true;
  return options;
}

}  // namespace

WalkMapper::WalkMapper(const MapperOptions& options)
    : options_(options),
      builder_(with_things(options.pieces)),
      finder_(with_file(options.loops, options.folder)) {}

void WalkMapper::add(const PlacedScan& scan, const DeskewedScan& points) {
  if (auto piece = builder_.add(scan, points)) finder_.add(std::move(*piece));
}

void WalkMapper::finish() {
  if (auto piece = builder_.finish()) finder_.add(std::move(*piece));
  finder_.finish();
  loops_ = finder_.loops();
  graph_.poses.clear();
  for (const Piece& piece : pieces()) graph_.poses.push_back(piece.T_world_piece);
  graph_.edges = finder_.odometry();
  graph_.systematic = systematic_drift(options_.loops.drift);
  if (options_.close_loops) return close_loops();
  const std::vector<PoseEdge> homes = homecomings(pieces(), options_.loops.drift);
  graph_.edges.insert(graph_.edges.end(), homes.begin(), homes.end());
}

/// Within stretches that the odometry knows whole, then between them. Where it began anew nothing
/// limits where the robot can be: there as much is asked as of maps of different days, and under a
/// roof no storey is told from the next.
void WalkMapper::close_loops() {
  std::vector<std::size_t> chosen;
  const std::vector<std::size_t> stretches = stretches_of(pieces());
  for (std::size_t stretch = 0; !stretches.empty() && stretch <= stretches.back(); ++stretch) {
    const std::vector<std::size_t> agreeing = keep_consistent(
        graph_, loops_, [&](const Loop& loop) { return stretches[loop.query] == stretch; });
    chosen.insert(chosen.end(), agreeing.begin(), agreeing.end());
  }
  take_loops(graph_, loops_, chosen);
  MergeOptions joining;
  joining.limits = options_.loops.limits;
  joining.drift = options_.loops.drift;
  joining.roofed = false;
  const std::vector<Loop> between = join_stretches(pieces(), finder_.index(), graph_, joining);
  loops_.insert(loops_.end(), between.begin(), between.end());
}

std::size_t WalkMapper::taken() const {
  return static_cast<std::size_t>(std::count_if(loops_.begin(), loops_.end(), [](const Loop& loop) {
    return loop.check.verdict == LoopVerdict::taken;
  }));
}

Pose WalkMapper::correction(std::int64_t time_ns) const {
  return correction_at(pieces(), graph_.poses, time_ns);
}

Pose correction_at(const std::vector<Piece>& pieces, const std::vector<Pose>& corrected,
                   std::int64_t time_ns) {
  if (pieces.empty() || corrected.size() != pieces.size()) return {};
  const auto at = [&](std::size_t i) { return corrected[i] * pieces[i].T_world_piece.inverse(); };
  const auto after = static_cast<std::size_t>(
      std::upper_bound(pieces.begin(), pieces.end(), time_ns,
                       [](std::int64_t time, const Piece& piece) { return time < piece.time_ns; }) -
      pieces.begin());
  if (after == 0) return at(0);
  if (after == pieces.size()) return at(after - 1);
  if (pieces[after].restarted) return at(time_ns < pieces[after].begin_ns ? after - 1 : after);
  // The motion between the two corrected pieces, spread evenly over the odometry's: interpolated at
  // where the robot was, so that it does not matter how far away the world's origin is.
  const double share = static_cast<double>(time_ns - pieces[after - 1].time_ns) /
                       static_cast<double>(std::max<std::int64_t>(
                           pieces[after].time_ns - pieces[after - 1].time_ns, 1));
  const Pose& before_pose = pieces[after - 1].T_world_piece;
  const Pose correction_before = at(after - 1);
  const Pose correction_after = at(after);
  const Pose between =
      (correction_before * before_pose).inverse() * (correction_after * before_pose);
  const Pose here = correction_before * before_pose * se3_exp(share * se3_log(between));
  return here * before_pose.inverse();
}

}  // namespace surefoot::mapping
