// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a submap saw that there is nothing: a wall of another one that would stand there shows that
// the two are not one place, however much else fits.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

class FreeSpace {
 public:
  explicit FreeSpace(const Submap& submap);

  enum class Sight {
    unknown,
    occupied,  ///< something was seen here or in a neighbouring cube
    empty      ///< beams went through, and nothing was seen near
  };
  [[nodiscard]] Sight at(const Eigen::Vector3d& place) const;

 private:
  [[nodiscard]] bool occupied_about(const Eigen::Vector3i& index) const;

  VoxelTable occupied_;
  VoxelTable passed_;                 // index into passes_
  std::vector<std::uint8_t> passes_;  // beams, to 255
};

}  // namespace surefoot::mapping
