// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where in a map a place may be of which nothing is known but what it looks like.
#pragma once

#include <cstddef>
#include <vector>

#include "mapping/loop_verifier.hpp"
#include "mapping/piece.hpp"
#include "mapping/place_index.hpp"

namespace surefoot::mapping {

/// The places that look most alike, one of each area, the best first, at most `most`: beside one
/// place its neighbours would leave no room for its likes. `index` holds the pieces' places.
[[nodiscard]] std::vector<PlaceIndex::Match> distinct_places(const PlaceIndex& index,
                                                             const std::vector<Piece>& pieces,
                                                             const Submap& seen, std::size_t most);

/// T_place_query as the descriptors say it, on the ground that both stand on.
[[nodiscard]] Pose rough_pose(const PlaceIndex::Match& match, const Submap& place,
                              const Submap& seen);

/// How far apart two places are as areas [m]: those of storeys are areas of their own.
[[nodiscard]] double area_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// From where registration starts about a rough pose: there, and turned a little both ways.
[[nodiscard]] std::vector<Pose> turned_both_ways(const Pose& pose);

/// Asks whether `seen` is the place that a search named.
[[nodiscard]] LoopCheck check_match(const PlaceIndex::Match& match, const VerifiableSubmap& place,
                                    const VerifiableSubmap& seen, const LoopLimits& limits);

}  // namespace surefoot::mapping
