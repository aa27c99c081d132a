// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Places that two maps share. Nothing says where the one lies in the other: pieces spread over the
// second map are compared with what looks like them anywhere in the first. Once these tell how the
// maps lie, the others are compared only where they would lie.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "mapping/loop_finder.hpp"
#include "mapping/map_file.hpp"
#include "mapping/map_placement.hpp"

namespace surefoot::mapping {

struct MergeOptions {
  LoopLimits limits;
  DriftModel drift;
  std::size_t candidates = 6;  ///< places of the first map that are verified for each piece
  std::size_t survey = 100;    ///< pieces that are compared with all of the first map, at least
  std::size_t enough = 5;      ///< loops of these say how the maps lie, at least, before others are
                               ///< compared only where they would lie
  std::size_t placements = 8;  ///< ways in which the maps may lie, that are gone into
  /// The second-best way to lay two places over each other has so much of the best one's overlap,
  /// at most.
  double as_good = 0.65;
  double spread = 10.0;  ///< agreeing loops begin in places so far apart, at least [m]
  /// Over all places that both maps have seen: furniture and doors move, walls do not.
  double contradicted = 0.05;
  double overlap = 0.5;
  /// So much of what fits as the maps lie may fit otherwise: places that look alike.
  double likes = 0.1;
  /// Told after each piece of the second map that was compared, how many were, and of how many.
  std::function<void(std::size_t done, std::size_t all)> on_piece = {};
  /// Whether places under a roof tell how the maps lie: one storey may look like the next.
  bool roofed = true;
};

/// What speaks against a placement by itself, in one sentence; empty: nothing, it fits.
[[nodiscard]] std::string objection(const MapPlacement& placement, const MergeOptions& options);
[[nodiscard]] inline bool fits(const MapPlacement& placement, const MergeOptions& options) {
  return objection(placement, options).empty();
}

/// What came of comparing pieces of the second map (`query`) with pieces of the first (`place`), by
/// the query's number. No drift is known.
[[nodiscard]] std::vector<Loop> find_joint_places(const SavedMap& first, const MapPair& pair,
                                                  const MergeOptions& options);

}  // namespace surefoot::mapping
