// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a sensor may be, some time after its last trusted scan. docs/method.md, "Lost".
#pragma once

#include <cstdint>
#include <optional>

#include "core/preprocess.hpp"
#include "methods/knots/knot_search.hpp"
#include "methods/knots/velocity_model.hpp"
#include "methods/knots/walked_way.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// What is known of it. Instants are stamps [ns]; what is referred to outlives it. Poses are
/// T_map_lidar, but those of regions an upright carrier's, which is where the LiDAR is.
struct Whereabouts {
  const Pose& last;                 ///< where it was last taken to be
  const Eigen::Quaterniond& mount;  ///< R_lidar_carrier
  std::int64_t trusted_ns;          ///< the last trusted pose's instant
  std::int64_t trusted_end_ns;      ///< the end of its scan
  const VelocityModel& model;
  const WalkedWay& way;
  double extrapolated;  ///< [s] after which the velocity no longer tells where it is
  bool walked_unseen;   ///< it was lost in a hole of the recording

  /// [s] from the last trusted pose to an instant.
  [[nodiscard]] double since(std::int64_t instant_ns) const;
  /// Whether the last trusted scan ended too long ago for its velocity to tell where this one
  /// begins.
  [[nodiscard]] bool is_after_hole(const PreparedScan& scan) const;
  /// Likewise, but so short ago that it has not turned since.
  [[nodiscard]] bool is_after_short_hole(const PreparedScan& scan) const;
  /// Whether a place lies behind where the last trusted scan ended, for one who walked on unseen
  /// for so short.
  [[nodiscard]] bool is_farther_back(const Pose& place, const PreparedScan& scan) const;
  /// Whether who climbs may have come to where the next storey looks as this one does here.
  [[nodiscard]] bool may_be_a_storey_on(std::int64_t instant_ns) const;

  /// About where it would be had it walked straight on, on the ground of its way.
  [[nodiscard]] SearchRegion straight_on(std::int64_t instant_ns) const;
  /// The pose there.
  [[nodiscard]] Pose going_straight_on(std::int64_t instant_ns) const;
  /// The same place, as high as if it climbed on as of late.
  [[nodiscard]] Pose climbing_on(std::int64_t instant_ns) const;
  /// Where it may be if it went on as it walked.
  [[nodiscard]] SearchRegion walked(std::int64_t instant_ns) const;
  /// Where it may be if it was carried.
  [[nodiscard]] SearchRegion carried(std::int64_t instant_ns) const;
  /// As far as it is ever looked for, and turned anyhow.
  [[nodiscard]] SearchRegion anywhere() const;
  /// Likewise about a place [m].
  [[nodiscard]] SearchRegion anywhere_about(const Eigen::Vector3d& place) const;
  /// Where it is looked for by the so-many-th scan that asks whether it came back to this map,
  /// which it left for another one: about one place of its way after the other.
  [[nodiscard]] SearchRegion come_back(int scans) const;
  /// Where it is looked for by the scan whose turn it is, after so many others; nowhere by some of
  /// those for which it would be far.
  [[nodiscard]] std::optional<SearchRegion> of_turn(int scans, std::int64_t instant_ns) const;

 private:
  [[nodiscard]] Pose last_carrier() const;
  [[nodiscard]] SearchRegion within(double speed, std::int64_t instant_ns) const;
};

}  // namespace surefoot
