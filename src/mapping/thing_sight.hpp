// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What was seen of single things: where something stood, and where beams went through. Dozens of
// these are asked in turn, so that a cube is two bits of a block of 4 x 4 x 4.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/free_space.hpp"

namespace surefoot::mapping {

class ThingSight {
 public:
  /// `stands`: whether a point [m, the submap's frame] is something; the others only end beams.
  ThingSight(const Submap& submap, const std::function<bool(const Eigen::Vector3f& point)>& stands);

  [[nodiscard]] FreeSpace::Sight at(const Eigen::Vector3d& place) const;

 private:
  struct Block {
    std::uint64_t occupied = 0;  ///< something was seen in the cube or a neighbouring one
    std::uint64_t empty = 0;     ///< beams went through, unless it is occupied
  };

  VoxelTable table_;  // index into blocks_
  std::vector<Block> blocks_;
};

}  // namespace surefoot::mapping
