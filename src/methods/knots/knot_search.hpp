// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a sensor that lost itself may be. docs/method.md, "Lost".
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "methods/knots/surfel_map.hpp"
#include "methods/knots/walked_way.hpp"
#include "surefoot/config.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// The pose of an upright carrier that a LiDAR is on, at the same place, and the other way round.
/// `mount`: R_lidar_carrier.
[[nodiscard]] inline Pose carrier_of(const Pose& T_map_lidar, const Eigen::Quaterniond& mount) {
  return {T_map_lidar.rotation * mount, T_map_lidar.translation};
}
[[nodiscard]] inline Pose lidar_on(const Pose& T_map_carrier, const Eigen::Quaterniond& mount) {
  return {T_map_carrier.rotation * mount.conjugate(), T_map_carrier.translation};
}

/// Where to look: about a carrier's pose, so far away in the plane [m] and turned by so much [rad].
struct SearchRegion {
  Pose centre;
  double radius = 0.0;
  double turn = 0.0;
  // By how much a place may be lower or higher than the centre [m]: anything, unless said.
  double below = std::numeric_limits<double>::infinity();
  double above = std::numeric_limits<double>::infinity();

  /// Leaves out other storeys, and to who climbs or goes down (of late by so much [m]; zero:
  /// neither) where he came from.
  void keep_to_storey(double climb);
  /// Whether a place is neither too low nor too high.
  [[nodiscard]] bool is_as_high(const Eigen::Vector3d& place) const;
  /// Whether it may well hold places that look alike.
  [[nodiscard]] bool large() const { return radius > 6.0; }
};

/// How well a scan fits a map, seen coarsely.
struct PlaceFit {
  Pose pose;
  double fit = 0.0;  ///< 0: no point meets anything; 1: every point lies on its surfel
};

/// Whether two poses are near enough to each other for a registration to go from one to the other.
[[nodiscard]] bool same_place(const Pose& a, const Pose& b);

/// What has a `pose`: the best of them, best first, no two at the same place, `most` at most.
template <typename Placed, typename Better>
[[nodiscard]] std::vector<Placed> best_apart(std::vector<Placed> all, std::size_t most,
                                             const Better& better) {
  std::stable_sort(all.begin(), all.end(), better);
  std::vector<Placed> best;
  for (Placed& one : all) {
    if (best.size() == most) break;
    const bool known = std::any_of(best.begin(), best.end(), [&](const Placed& other) {
      return same_place(one.pose, other.pose);
    });
    if (!known) best.push_back(std::move(one));
  }
  return best;
}

/// How thoroughly places are looked through.
struct SearchEffort {
  bool settled;         ///< also turned between the steps, and more tilted than the way
  std::size_t refined;  ///< of the places of the first grid, the best ones
};
inline constexpr SearchEffort kGlance{false, 8}, kThorough{true, 48};

/// The poses of a region, on the ground of a way, where some of a scan's points [m, carrier's
/// frame], as one rigid body, fit best: best first, no two near each other, `most` at most.
[[nodiscard]] std::vector<PlaceFit> search_places(const SurfelMap& map,
                                                  const std::vector<Eigen::Vector3d>& points,
                                                  const SearchRegion& region, const WalkedWay& way,
                                                  std::size_t most, const SearchEffort& effort,
                                                  const Workers& workers);

}  // namespace surefoot
