// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_search.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/se3.hpp"

namespace surefoot::mapping {

std::vector<PlaceIndex::Match> distinct_places(const PlaceIndex& index,
                                               const std::vector<Piece>& pieces, const Submap& seen,
                                               std::size_t most) {
  constexpr double kSameArea = 7.0;  // places so near each other are one candidate [m]
  const auto all = index.search(
      describe_with_offsets(seen), [](std::size_t) { return true; }, 5 * most);
  std::vector<PlaceIndex::Match> result;
  for (const PlaceIndex::Match& match : all) {
    const Eigen::Vector3d& at = pieces[match.place].T_world_piece.translation;
    const bool known = std::any_of(result.begin(), result.end(), [&](const auto& other) {
      return area_distance(pieces[other.place].T_world_piece.translation, at) < kSameArea;
    });
    if (!known) result.push_back(match);
    if (result.size() == most) break;
  }
  return result;
}

double area_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kHeightCounts = 4.0;
  Eigen::Vector3d apart = a - b;
  apart.z() *= kHeightCounts;
  return apart.norm();
}

Pose rough_pose(const PlaceIndex::Match& match, const Submap& place, const Submap& seen) {
  Pose on_slopes = match.T_place_query;
  on_slopes.translation.z() = place.slope_ground - seen.slope_ground;
  const Pose T_slope_place{place.to_slope, Eigen::Vector3d::Zero()};
  const Pose T_slope_seen{seen.to_slope, Eigen::Vector3d::Zero()};
  return T_slope_place.inverse() * on_slopes * T_slope_seen;
}

std::vector<Pose> turned_both_ways(const Pose& pose) {
  constexpr double kTurn = 6.0 * std::numbers::pi / 180.0;  // a sector of the descriptors
  constexpr double kAside = 0.4;                            // [m]
  std::vector<Pose> result;
  for (const double side : {0.0, -1.0, 1.0}) {
    result.push_back(
        pose *
        se3_exp(
            (Twist() << kAside * side, -kAside * side, 0.0, 0.0, 0.0, side * kTurn).finished()));
  }
  return result;
}

LoopCheck check_match(const PlaceIndex::Match& match, const VerifiableSubmap& place,
                      const VerifiableSubmap& seen, const LoopLimits& limits) {
  const Pose rough = rough_pose(match, place.submap(), seen.submap());
  return check_places(place, seen, turned_both_ways(rough), limits);
}

}  // namespace surefoot::mapping
