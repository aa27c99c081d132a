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

/// What the front-end does not say itself: its covariance is of a pose against its own map, which
/// drifts. Some of it is a random walk, some is wrong the same way all along (beams that are a
/// little off, a gait that always sways alike). The systematic part is a margin, not measured.
struct DriftModel {
  double translation = 0.01;  ///< [m] after one metre of way; grows with the square root
  double rotation_deg = 0.012;
  double standing = 0.005;                ///< [m] between two pieces, however short the way
  double systematic_translation = 0.001;  ///< [m] a metre; grows with the way
  double systematic_rotation_deg = 0.005;
};

/// As PoseGraph::systematic.
[[nodiscard]] Twist systematic_drift(const DriftModel& model);

/// The motion from a piece to the next as the odometry has it. Information of 1e-9 where it began
/// anew.
[[nodiscard]] PoseEdge odometry_edge(const std::vector<Piece>& pieces, std::size_t from,
                                     const DriftModel& model);

/// What the odometry knows where it came home, into the frame of pieces that it had left: one edge
/// for each time, from the nearest of these to the first piece since, as uncertain as if it had
/// walked from there, since it is that part of the map that it was found in. They may be switched
/// off: it may have taken another place for home.
[[nodiscard]] std::vector<PoseEdge> homecomings(const std::vector<Piece>& pieces,
                                                const DriftModel& model);

/// Covariance of the odometry's motion from one piece to a later one, of a small motion in the
/// later one's frame.
[[nodiscard]] Matrix6 drift_between(const std::vector<Piece>& pieces,
                                    const std::vector<PoseEdge>& odometry, std::size_t from,
                                    std::size_t to, const DriftModel& model);
/// The same from every piece up to `to`, each.
[[nodiscard]] std::vector<Matrix6> drifts_to(const std::vector<Piece>& pieces,
                                             const std::vector<PoseEdge>& odometry, std::size_t to,
                                             const DriftModel& model);

}  // namespace surefoot::mapping
