// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "methods/knots/surfel_map.hpp"

namespace surefoot {

/// The answers of SurfelMap::find() within a box, each a few steps in an array away: for who asks
/// a million times. The map must not change meanwhile.
class SurfelLookup {
 public:
  /// @param finest the finest grid that is asked
  /// @param box [m, map frame] about most of the places that will be asked for
  SurfelLookup(const SurfelMap& map, int finest, const Eigen::AlignedBox3d& box);

  /// Likewise, from the same grid on. Outside of the box the map is asked.
  [[nodiscard]] const Surfel* find(const Eigen::Vector3d& place, const Eigen::Vector3d& ray) const;

 private:
  /// A voxel with a surfel, and the next coarser one about it that has one.
  struct Node {
    const Surfel* front;
    const Surfel* back;
    std::uint32_t next;

    /// The side that a ray can have hit, or null.
    [[nodiscard]] const Surfel* hit_by(const Eigen::Vector3d& ray) const {
      if (!front->from_behind(ray)) return front;
      return back == nullptr || back->from_behind(ray) ? nullptr : back;
    }
  };
  static constexpr std::uint32_t kNone = 0;

  void add(int level);
  [[nodiscard]] std::size_t cell_of(const VoxelIndex& at) const {
    return (static_cast<std::size_t>(at.x()) * extent_.y() + at.y()) * extent_.z() + at.z();
  }

  const SurfelMap& map_;
  int finest_;
  double inverse_size_;               // [1/m] of the finest grid's voxels
  VoxelIndex first_, extent_;         // of the box, in the finest grid
  std::vector<Node> nodes_;           // the first one is none
  std::vector<std::uint32_t> cells_;  // of each voxel of the box, its finest node
};

inline const Surfel* SurfelLookup::find(const Eigen::Vector3d& place,
                                        const Eigen::Vector3d& ray) const {
  const VoxelIndex at = voxel_index(place, inverse_size_) - first_;
  const bool outside = (at.array() < 0).any() || (at.array() >= extent_.array()).any();
  if (outside) return map_.find(place, ray, finest_);
  const Surfel* cloud = nullptr;
  for (std::uint32_t i = cells_[cell_of(at)]; i != kNone; i = nodes_[i].next) {
    const Surfel* const surfel = nodes_[i].hit_by(ray);
    if (surfel == nullptr || surfel->directions == 0) continue;
    if (!surfel->cloud()) return surfel;
    if (cloud == nullptr) cloud = surfel;
  }
  return cloud;
}

}  // namespace surefoot
