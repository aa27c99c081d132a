// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A place as it is compared with others: a piece of way and those before and after it, together.
// Single sweeps of sixteen beams see too little to tell places apart.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mapping/piece.hpp"

namespace surefoot::mapping {

struct Submap {
  std::vector<Eigen::Vector3f> points;   ///< [m] the frame of the middle piece: level
  std::vector<Eigen::Vector3f> eyes;     ///< of each point: from where it was seen
  double ground = 0.0;                   ///< height of the ground about the middle [m]
  bool covered = false;                  ///< a ceiling is above
  Matrix6 covariance = Matrix6::Zero();  ///< as Piece::covariance, of its least certain piece
};

/// The pieces from `index - reach` to `index + reach`, as far as there are any and the odometry
/// knows where they lie against each other; one point a cube of side `voxel`.
[[nodiscard]] Submap make_submap(const std::vector<Piece>& pieces, std::size_t index,
                                 std::size_t reach = 1, double voxel = 0.2);
/// A single piece.
[[nodiscard]] Submap make_submap(const Piece& piece);

}  // namespace surefoot::mapping
