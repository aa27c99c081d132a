// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "methods/shared/voxel_map.hpp"

namespace surefoot {

/// Finds several neighbours in a VoxelMap, in all cells within a radius.
class VoxelNeighbours {
 public:
  struct Neighbour {
    double distance2;  ///< [m^2]
    const Eigen::Vector3d* point;
    friend bool operator<(const Neighbour& a, const Neighbour& b) {
      return a.distance2 < b.distance2;
    }
  };

  /// At most `count` neighbours, none farther than `radius` [m]. The map must outlive this.
  VoxelNeighbours(const VoxelMap& map, double radius, std::size_t count);

  /// The query's nearest neighbours, nearest first. They hold until the map changes.
  void find(const Eigen::Vector3d& query, std::vector<Neighbour>& found) const;

 private:
  const VoxelMap& map_;
  double radius2_;
  std::size_t count_;
  int reach_;                       // cells to either side
  std::vector<VoxelIndex> shifts_;  // to these cells, nearest kinds first
};

}  // namespace surefoot
