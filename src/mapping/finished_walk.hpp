// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a walk's map comes to when the walk is over: by itself, or joined to a saved one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mapping/map_merge.hpp"
#include "mapping/walk_mapper.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::mapping {

/// What a finished mapper knows, at its corrected poses.
[[nodiscard]] SavedMap saved_map_of(const WalkMapper& mapper);

/// Poses of one frame, one after the other.
struct FramePoses {
  std::size_t frame = 0;  ///< stretches of one number are held together; the first one's is 0
  Trajectory poses;
};

class FinishedWalk {
 public:
  /// A mapper that has finished.
  explicit FinishedWalk(const WalkMapper& mapper);

  /// Drops what came and went from the map: what was seen from one place, and through from others.
  /// Before join().
  void drop_moved();
  /// Of points that were seen at these times along the walk, ascending, and stand where they belong
  /// after all loops [m], those that came and went.
  [[nodiscard]] std::vector<bool> moved(const std::vector<Eigen::Vector3f>& points,
                                        const std::vector<std::int64_t>& times_ns) const;

  /// Joins it to a map: then all that follows is in that map's frame, and it is joined to no other
  /// (std::logic_error). Else nothing changes.
  MapJoin join(const SavedMap& map);

  /// T_map_odometry at a time along the walk; smooth between the pieces. None where nothing holds
  /// the piece to the map that it was joined to.
  [[nodiscard]] std::optional<Pose> correction(std::int64_t time_ns) const;
  /// In which frame that is, of those that nothing joins.
  [[nodiscard]] std::size_t frame_at(std::int64_t time_ns) const;
  /// The odometry's poses, all that the mapper was given, corrected; without those that have none.
  /// Taken apart where the next one is in another frame.
  [[nodiscard]] std::vector<FramePoses> corrected(const Trajectory& measured) const;
  [[nodiscard]] const SavedMap& map() const { return map_; }
  [[nodiscard]] PoseGraph graph() const;

 private:
  [[nodiscard]] std::size_t piece_at(std::int64_t time_ns) const;

  std::vector<Piece> pieces_;        // of the walk, by the odometry
  std::vector<Pose> poses_;          // of them, corrected
  std::vector<std::size_t> held_;    // of them, which are held together
  std::vector<std::size_t> frames_;  // of them, numbered as they come
  bool is_joined_ = false;
  std::vector<bool> placed_;  // whether anything holds them in the map
  SavedMap map_;
  std::shared_ptr<CloudFile> clouds_;
};

}  // namespace surefoot::mapping
