// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/surfel_lookup.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kMostCells = 16e6;  // 64 MB, where a map reaches for kilometres

/// What of a box holds surfels; if that is too much, its middle.
Eigen::AlignedBox3d worth_an_array(const SurfelMap& map, int finest,
                                   const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d held;
  for (int level = finest; level < map.levels(); ++level) {
    const double size = map.size_of(level);
    map.for_each_front(level, [&](const VoxelIndex& index, const Surfel&, const Surfel*) {
      const Eigen::Vector3d corner = size * index.cast<double>();
      held.extend(corner).extend(corner + Eigen::Vector3d::Constant(size));
    });
  }
  const Eigen::AlignedBox3d both = box.intersection(held);
  if (both.isEmpty()) return {box.center(), box.center()};
  const double cells = (both.sizes() / map.size_of(finest)).prod();
  const double shrunk = std::min(std::cbrt(kMostCells / cells), 1.0);
  const Eigen::Vector3d half = 0.5 * shrunk * both.sizes();
  return {both.center() - half, both.center() + half};
}

}  // namespace

SurfelLookup::SurfelLookup(const SurfelMap& map, int finest, const Eigen::AlignedBox3d& box)
    : map_(map), finest_(finest), inverse_size_(1.0 / map.size_of(finest)), nodes_(1) {
  const Eigen::AlignedBox3d kept = worth_an_array(map, finest, box);
  first_ = voxel_index(kept.min(), inverse_size_);
  extent_ = voxel_index(kept.max(), inverse_size_) - first_ + VoxelIndex::Ones();
  cells_.resize(static_cast<std::size_t>(extent_.x()) * extent_.y() * extent_.z(), kNone);
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
