// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Relative pose error: how far the estimate's motion over a stretch is from the reference's.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/association.hpp"
#include "evaluation/pose_error.hpp"

namespace surefoot::evaluation {

enum class DeltaUnit { frames, metres, seconds, degrees };

struct PairOptions {
  double delta = 1.0;  ///< length of a stretch; whole and >= 1 for frames, at most 180 deg
  DeltaUnit unit = DeltaUnit::frames;
  bool all_pairs = false;  ///< a stretch from every pose, instead of one after the other
  double tolerance = 0.1;  ///< all_pairs: accepted deviation from delta, as a share of it
};

/// Start and end of a stretch.
struct IndexPair {
  std::size_t from = 0, to = 0;
};

/// The stretches of length delta along a trajectory, as evo chooses them:
/// one after the other, a stretch ends at the first pose at which its path, time or turn (summed
/// from pose to pose) reaches delta; along the path the first such pose is where the first stretch
/// begins. With all_pairs it ends at the pose nearest to delta, within the tolerance; for degrees,
/// at every pose that is turned by delta within the tolerance against the start.
/// Throws std::invalid_argument if delta is not finite, not positive or not possible.
[[nodiscard]] std::vector<IndexPair> find_pairs(const Trajectory& trajectory,
                                                const PairOptions& options);

/// Size of (T_ref_i^-1 T_ref_j)^-1 (T_est_i^-1 T_est_j) for each stretch.
[[nodiscard]] std::vector<double> relative_errors(const AssociatedTrajectories& pairs,
                                                  const std::vector<IndexPair>& stretches,
                                                  Relation relation);

/// | |t_ref| - |t_est| | of each stretch [m]: distances alone, whatever the directions.
[[nodiscard]] std::vector<double> relative_distance_errors(const AssociatedTrajectories& pairs,
                                                           const std::vector<IndexPair>& stretches);
/// The same in percent of |t_ref|; stretches over which the reference stays within, or returns to,
/// 10 um of its start are left out.
[[nodiscard]] std::vector<double> relative_distance_error_percents(
    const AssociatedTrajectories& pairs, const std::vector<IndexPair>& stretches);

}  // namespace surefoot::evaluation
