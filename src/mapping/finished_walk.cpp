// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/finished_walk.hpp"

#include <algorithm>
#include <cstddef>

namespace surefoot::mapping {

SavedMap saved_map_of(const WalkMapper& mapper) {
  SavedMap map;
  map.pieces = mapper.pieces();
  map.edges = mapper.graph().edges;
  for (std::size_t i = 0; i < map.pieces.size(); ++i) {
    map.pieces[i].T_world_piece = mapper.graph().poses[i];
    map.places.push_back(describe_place(make_submap(mapper.pieces(), i)));
  }
  return map;
}

FinishedWalk::FinishedWalk(const WalkMapper& mapper)
    : pieces_(mapper.pieces()),
      poses_(mapper.graph().poses),
      placed_(poses_.size(), true),
      map_(saved_map_of(mapper)) {}

MapJoin FinishedWalk::join(const SavedMap& map) {
  MapJoin join = join_maps(map, map_);
  if (!join.joint) return join;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    placed_[i] = join.placed[i].has_value();
    if (placed_[i]) poses_[i] = *join.placed[i];
  }
  map_ = *join.joint;
  return join;
}

Pose FinishedWalk::correction(std::int64_t stamp_ns) const {
  return correction_at(pieces_, poses_, stamp_ns);
}

Trajectory FinishedWalk::corrected(const Trajectory& measured) const {
  Trajectory result;
  for (const StampedPose& pose : measured) {
    const auto next = std::upper_bound(
        pieces_.begin(), pieces_.end(), pose.stamp_ns,
        [](std::int64_t stamp, const Piece& piece) { return stamp < piece.begin_ns; });
    const auto piece = std::max<std::ptrdiff_t>(next - pieces_.begin() - 1, 0);
    if (!placed_.empty() && !placed_[static_cast<std::size_t>(piece)]) continue;
    result.push_back({pose.stamp_ns, correction(pose.stamp_ns) * pose.pose});
  }
  return result;
}

PoseGraph FinishedWalk::graph() const {
  PoseGraph graph;
  for (const Piece& piece : map_.pieces) graph.poses.push_back(piece.T_world_piece);
  graph.edges = map_.edges;
  return graph;
}

}  // namespace surefoot::mapping
