// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How far the odometry may have gone astray between two pieces: what a loop may claim, and how
// strongly the graph holds the way together.
#pragma once

#include <cstddef>
#include <vector>

#include "mapping/piece.hpp"
#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Random walks beside what the front-end says itself: its covariance is of a pose against its own
/// map, which drifts.
struct DriftModel {
  double translation = 0.01;  ///< [m] after one metre of way; grows with the square root
  double rotation_deg = 0.012;
  double standing = 0.005;  ///< [m] between two pieces, however short the way
};

/// The motion from a piece to the next as the odometry has it. Information of 1e-9 where it began
/// anew.
[[nodiscard]] PoseEdge odometry_edge(const std::vector<Piece>& pieces, std::size_t from,
                                     const DriftModel& model);

/// Covariance of the odometry's motion from one piece to a later one, of a small motion in the
/// later one's frame.
[[nodiscard]] Matrix6 drift_between(const std::vector<Piece>& pieces,
                                    const std::vector<PoseEdge>& odometry, std::size_t from,
                                    std::size_t to);

}  // namespace surefoot::mapping
