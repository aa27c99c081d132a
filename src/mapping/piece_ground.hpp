// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What stands on the ground of a piece of way, and what is the ground.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

class PieceGround {
 public:
  /// Of a single piece.
  explicit PieceGround(const Submap& submap);

  /// [m] Over the plane of the ground about the middle.
  [[nodiscard]] float height(const Eigen::Vector3f& place) const {
    return R_slope_.row(2).dot(place) - ground_;
  }
  /// Whether a place is out of the ground: above the plane, and not on what lies as low far and
  /// wide, which is ground that the plane does not follow.
  [[nodiscard]] bool stands(const Eigen::Vector3f& place) const;

 private:
  Eigen::Matrix3f R_slope_;
  float ground_;
  VoxelTable squares_;  // of a metre; index into lowest_
  std::vector<float> lowest_;
};

}  // namespace surefoot::mapping
