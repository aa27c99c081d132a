// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel_lookup.hpp"

#include <algorithm>

namespace surefoot {

SurfelLookup::SurfelLookup(const SurfelMap& map, int finest, const Eigen::AlignedBox3d& box)
    : map_(map),
      finest_(finest),
      inverse_size_(1.0 / map.size_of(finest)),
      first_(voxel_index(box.min(), inverse_size_)),
      extent_(voxel_index(box.max(), inverse_size_) - first_ + VoxelIndex::Ones()),
      nodes_(1),
      cells_(static_cast<std::size_t>(extent_.x()) * extent_.y() * extent_.z(), kNone) {
  // From coarse to fine: a finer voxel finds in its cells what is coarser.
  for (int level = map.levels() - 1; level >= finest; --level) add(level);
}

void SurfelLookup::add(int level) {
  const int wide = 1 << (level - finest_);  // cells
  map_.for_each_front(level, [&](const VoxelIndex& index, const Surfel& front, const Surfel* back) {
    const VoxelIndex begin = (index * wide - first_).cwiseMax(0);
    const VoxelIndex end = ((index + VoxelIndex::Ones()) * wide - first_).cwiseMin(extent_);
    if ((begin.array() >= end.array()).any()) return;
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({&front, back, cells_[cell_of(begin)]});
    for (int x = begin.x(); x < end.x(); ++x) {
      for (int y = begin.y(); y < end.y(); ++y) {
        const auto row = cells_.begin() + static_cast<std::ptrdiff_t>(cell_of({x, y, 0}));
        std::fill(row + begin.z(), row + end.z(), node);
      }
    }
  });
}

}  // namespace surefoot
