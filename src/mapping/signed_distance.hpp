// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How far a place lies before what was seen, or behind it, at the corners of a grid: Hoppe et al.
// (Surface reconstruction from unorganized points, SIGGRAPH 1992), with the tangent planes of all
// points about a corner instead of the nearest one's.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/oriented_points.hpp"

namespace surefoot::mapping {

class SignedDistance {
 public:
  /// `cell`: side of the grid's cells [m].
  explicit SignedDistance(double cell) : cell_(cell) {}

  void add(const OrientedPoint& point);
  /// [m] positive before the surface; NaN where none is near.
  [[nodiscard]] double at(const VoxelIndex& corner) const;
  /// Corners near a surface, in the order in which they were met.
  [[nodiscard]] const std::vector<VoxelIndex>& corners() const { return corners_; }

 private:
  struct Sum {
    float distance = 0.0F;
    float weight = 0.0F;
  };

  double cell_;
  VoxelTable table_;
  std::vector<VoxelIndex> corners_;
  std::vector<Sum> sums_;
};

}  // namespace surefoot::mapping
