// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Two saved maps as one, where they show the same places. A wrong joint is worse than none: what is
// not sure stays apart.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mapping/joint_places.hpp"
#include "mapping/loop_finder.hpp"
#include "mapping/map_comparison.hpp"
#include "mapping/map_file.hpp"

namespace surefoot::mapping {

/// What came of joining two maps.
struct MapJoin {
  std::vector<Piece> pieces;  ///< the first map's, then the second's, each in its map's frame
  std::size_t first = 0;      ///< so many of them are the first map's
  /// Every place of the second map (`query`) that was compared with one of the first (`place`), by
  /// their numbers in `pieces`, and what came of it. No drift is known.
  std::vector<Loop> loops;
  std::size_t taken = 0;
  MapComparison comparison;  ///< of the maps as the loops have them lie
  /// In the first map's frame, its first piece where it was; without those of the second that
  /// nothing holds to it. None where the maps could not be joined.
  std::optional<SavedMap> joint;
  /// T_first_piece, one a piece of the second map; none: nothing holds it to the first.
  std::vector<std::optional<Pose>> placed;
  std::string message;  ///< where they could not be joined: why, in one sentence

  /// So many pieces of the second map are placed.
  [[nodiscard]] std::size_t held() const;
  /// Where the second map begins, T_first_second, by the earliest piece that is placed; none where
  /// they could not be joined.
  [[nodiscard]] std::optional<Pose> begin() const;
};

/// Looks for the second map's places in the first, as strictly as for loops within a walk and,
/// since no odometry says where the one lies in the other, with more questions: docs/mapping.md.
/// Throws std::runtime_error if there is no solver.
[[nodiscard]] MapJoin join_maps(const SavedMap& first, const SavedMap& second,
                                const MergeOptions& options = {});

}  // namespace surefoot::mapping
