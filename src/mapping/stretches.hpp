// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A walk on which the odometry lost its way is several: where each stretch lies against the others
// nothing says, but where it came home. They are joined as maps of other days are, or not at all.
#pragma once

#include <cstddef>
#include <vector>

#include "mapping/loop_finder.hpp"
#include "mapping/map_merge.hpp"
#include "mapping/place_index.hpp"
#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Of each piece the number of its stretch: they end where the odometry began anew.
[[nodiscard]] std::vector<std::size_t> stretches_of(const std::vector<Piece>& pieces);

/// Joins what can be joined: moves the stretches' poses in the graph, adds what the odometry knows
/// where it came home (homecomings()) and the loops between them, and returns every place that was
/// compared, by the walk's numbers, the earlier one first where it can be. `places`: what the
/// pieces look like. Poses and edges within stretches are final.
[[nodiscard]] std::vector<Loop> join_stretches(const std::vector<Piece>& pieces,
                                               const PlaceIndex& places, PoseGraph& graph,
                                               const MergeOptions& options);

}  // namespace surefoot::mapping
