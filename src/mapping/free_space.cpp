// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/free_space.hpp"

#include <algorithm>
#include <cmath>

#include "core/voxel_key.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::uint8_t kEnough = 3;  // beams, to call a cube empty

}  // namespace

FreeSpace::FreeSpace(const Submap& submap, const Fineness& fineness,
                     const std::function<bool(const Eigen::Vector3f& point)>& stands)
    : inverse_cube_(1.0 / fineness.cube) {
  std::uint32_t count = 0;
  for (const Eigen::Vector3f& point : submap.points) {
    if (!stands(point)) continue;
    occupied_.find_or_insert(voxel_key(voxel_index(point.cast<double>(), inverse_cube_)), count++);
  }
  const auto step = static_cast<float>(0.9 * fineness.cube);
  const std::size_t every = submap.points.size() / fineness.beams + 1;
  for (std::size_t i = 0; i < submap.points.size(); i += every) {
    const Eigen::Vector3f beam = submap.points[i] - submap.eyes[i];
    const float length = beam.norm();
    const float end = std::min(length - fineness.before_end, fineness.longest);
    const Eigen::Vector3f along = beam / std::max(length, 1e-3F);
    std::uint64_t last = ~0ULL;
    for (float way = 0.3F; way < end; way += step) {
      const Eigen::Vector3f at = submap.eyes[i] + way * along;
      const std::uint64_t key = voxel_key(voxel_index(at.cast<double>(), inverse_cube_));
      if (key == last) continue;
      last = key;
      const auto [index, fresh] =
          passed_.find_or_insert(key, static_cast<std::uint32_t>(passes_.size()));
      if (fresh) passes_.push_back(0);
      if (passes_[index] < 255) ++passes_[index];
    }
  }
}

bool FreeSpace::occupied_about(const Eigen::Vector3i& index) const {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (occupied_.find(voxel_key(index + Eigen::Vector3i(x, y, z))) != VoxelTable::kNone) {
          return true;
        }
      }
    }
  }
  return false;
}

FreeSpace::Sight FreeSpace::at(const Eigen::Vector3d& place) const {
  const VoxelIndex index = voxel_index(place, inverse_cube_);
  const std::uint32_t passed = passed_.find(voxel_key(index));
  const bool seen_through = passed != VoxelTable::kNone && passes_[passed] >= kEnough;
  if (occupied_about(index)) return Sight::occupied;
  return seen_through ? Sight::empty : Sight::unknown;
}

}  // namespace surefoot::mapping
