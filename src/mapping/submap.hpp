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
  std::vector<Eigen::Vector3f> points;  ///< [m] the frame of the middle piece: level
  std::vector<Eigen::Vector3f> eyes;    ///< of each point: from where it was seen
  double ground = 0.0;                  ///< height of the ground about the middle [m]
  bool covered = false;                 ///< a ceiling is above
  /// R_slope_submap: to axes of which the third stands upright on the ground about the middle. How
  /// the world is tilted depends on where the odometry began; how the ground lies does not.
  Eigen::Quaterniond to_slope = Eigen::Quaterniond::Identity();
  double slope_ground = 0.0;             ///< height of the ground in these axes [m]
  Matrix6 covariance = Matrix6::Zero();  ///< as Piece::covariance, of its least certain piece
};

/// [m] Standard deviation of how far two submaps may be bent, kLever away: three times as much is
/// the 0.1 m and 1 degree by which registrations of them may differ.
inline constexpr double kMostBent = 0.067;

/// The pieces from `index - reach` to `index + reach`, as far as there are any and the odometry
/// knows where they lie against each other and was sure of its way; one point a cube of side
/// `voxel`.
[[nodiscard]] Submap make_submap(const std::vector<Piece>& pieces, std::size_t index,
                                 std::size_t reach = 1, double voxel = 0.2);
/// A single piece.
[[nodiscard]] Submap make_submap(const Piece& piece);

}  // namespace surefoot::mapping
