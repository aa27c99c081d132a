// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/finished_walk.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "mapping/held_pieces.hpp"
#include "mapping/moved_things.hpp"

namespace surefoot::mapping {

SavedMap saved_map_of(const WalkMapper& mapper) {
  SavedMap map;
  map.pieces = mapper.pieces();
  map.edges = mapper.graph().edges;
  for (std::size_t i = 0; i < map.pieces.size(); ++i) {
    map.pieces[i].T_world_piece = mapper.graph().poses[i];
    map.places.push_back(mapper.places().place(i));
  }
  return map;
}

FinishedWalk::FinishedWalk(const WalkMapper& mapper)
    : pieces_(mapper.pieces()),
      poses_(mapper.graph().poses),
      held_(held_together(mapper.graph())),
      frames_(frames_of(mapper.graph())),
      placed_(poses_.size(), true),
      map_(saved_map_of(mapper)),
      clouds_(mapper.clouds()) {}

void FinishedWalk::drop_moved() {
  MovedThings moved(map_.pieces, held_);
  mapping::drop_moved(map_.pieces, moved, clouds_);
}

std::vector<bool> FinishedWalk::moved(const std::vector<Eigen::Vector3f>& points,
                                      const std::vector<std::int64_t>& times_ns) const {
  std::vector<Piece> placed = pieces_;
  for (std::size_t i = 0; i < placed.size(); ++i) placed[i].T_world_piece = poses_[i];
  MovedThings things(placed, held_);
  std::vector<bool> result(points.size(), false);
  std::size_t begin = 0;
  for (std::size_t piece = 0; piece < placed.size(); ++piece) {
    const auto last = piece + 1 == placed.size();
    const auto end =
        last ? points.size()
             : static_cast<std::size_t>(
                   std::lower_bound(times_ns.begin(), times_ns.end(), placed[piece + 1].begin_ns) -
                   times_ns.begin());
    const Pose T_piece_world = poses_[piece].inverse();
    std::vector<Eigen::Vector3f> seen;
    for (std::size_t i = begin; i < end; ++i) {
      seen.emplace_back((T_piece_world * points[i].cast<double>()).cast<float>());
    }
    const std::vector<bool> gone = things.gone(piece, seen);
    std::copy(gone.begin(), gone.end(), result.begin() + static_cast<std::ptrdiff_t>(begin));
    begin = end;
  }
  return result;
}

MapJoin FinishedWalk::join(const SavedMap& map) {
  if (is_joined_) throw std::logic_error("a walk that was joined to a map is joined to no other");
  MapJoin join = join_maps(map, map_);
  if (!join.joint) return join;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    placed_[i] = join.placed[i].has_value();
    if (placed_[i]) poses_[i] = *join.placed[i];
  }
  frames_.assign(poses_.size(), 0);
  map_ = *join.joint;
  is_joined_ = true;
  return join;
}

/// The last one that has begun; the first one before.
std::size_t FinishedWalk::piece_at(std::int64_t time_ns) const {
  const auto next =
      std::upper_bound(pieces_.begin(), pieces_.end(), time_ns,
                       [](std::int64_t time, const Piece& piece) { return time < piece.begin_ns; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - pieces_.begin() - 1, 0));
}

std::optional<Pose> FinishedWalk::correction(std::int64_t time_ns) const {
  if (!placed_.empty() && !placed_[piece_at(time_ns)]) return std::nullopt;
  return correction_at(pieces_, poses_, time_ns);
}

std::size_t FinishedWalk::frame_at(std::int64_t time_ns) const {
  return frames_.empty() ? 0 : frames_[piece_at(time_ns)];
}

std::vector<FramePoses> FinishedWalk::corrected(const Trajectory& measured) const {
  std::vector<FramePoses> result;
  WalkClock clock;
  for (const StampedPose& pose : measured) {
    const std::int64_t time_ns = clock.next(pose.stamp_ns);
    const std::optional<Pose> T_map_odometry = correction(time_ns);
    if (!T_map_odometry) continue;
    const std::size_t frame = frame_at(time_ns);
    if (result.empty() || result.back().frame != frame) result.push_back({frame, {}});
    result.back().poses.push_back({pose.stamp_ns, *T_map_odometry * pose.pose});
  }
  return result;
}

PoseGraph FinishedWalk::graph() const { return graph_of(map_); }

}  // namespace surefoot::mapping
