// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a second map may lie in a first one's frame, by loops between them that agree.
#pragma once

#include <cstddef>
#include <vector>

#include "mapping/loop_finder.hpp"
#include "mapping/map_comparison.hpp"
#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Two maps' graph, the first's poses before the second's, and where each comes from.
struct MapPair {
  const std::vector<Piece>& pieces;  ///< each in its map's frame
  std::size_t first = 0;             ///< so many of them are the first map's
  PoseGraph graph;                   ///< of both, in which nothing joins the one to the other
  PoseGraph steps;                   ///< from piece to piece within each map, by which loops agree
};

struct MapPlacement {
  PoseGraph solved;                   ///< the pair's with the loops that hold, in the first's frame
  std::vector<Loop> loops;            ///< all, with what came of them
  std::size_t taken = 0;              ///< loops that hold
  double spread = 0.0;                ///< [m] how far their places lie apart, at most
  std::vector<Piece> pieces;          ///< where they lie
  std::vector<std::size_t> of_first;  ///< pieces of the first map that are held to each other
  std::vector<std::size_t> of_second;  ///< pieces of the second that are held to these
  MapComparison comparison;            ///< of these

  /// How many pieces of the second lie on what the first shows.
  [[nodiscard]] double support() const {
    return static_cast<double>(comparison.near) * comparison.overlap;
  }
};

/// Ways in which the second map may lie, that of the most agreeing loops first, `most` at most.
[[nodiscard]] std::vector<MapPlacement> find_placements(const MapPair& pair,
                                                        const std::vector<Loop>& loops,
                                                        std::size_t most);

}  // namespace surefoot::mapping
