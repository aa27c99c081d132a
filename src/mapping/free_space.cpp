// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/free_space.hpp"

namespace surefoot::mapping {

namespace {

// More beams say the same, and are as wide as a cube far away.
constexpr BeamFineness kOfPlaces{0.4, 25.0F, 0.8F, 15000};
constexpr double kCubesPerMetre = 1.0 / kOfPlaces.cube;  // [1/m]

}  // namespace

FreeSpace::FreeSpace(const Submap& submap) {
  std::uint32_t count = 0;
  for (const Eigen::Vector3f& point : submap.points) {
    occupied_.find_or_insert(voxel_key(voxel_index(point.cast<double>(), kCubesPerMetre)), count++);
  }
  follow_beams(submap, kOfPlaces, [&](const VoxelIndex& cube) {
    const auto [index, fresh] =
        passed_.find_or_insert(voxel_key(cube), static_cast<std::uint32_t>(passes_.size()));
    if (fresh) passes_.push_back(0);
    if (passes_[index] < 255) ++passes_[index];
  });
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
  const VoxelIndex index = voxel_index(place, kCubesPerMetre);
  const std::uint32_t passed = passed_.find(voxel_key(index));
  const bool seen_through = passed != VoxelTable::kNone && passes_[passed] >= kEnoughBeams;
  if (occupied_about(index)) return Sight::occupied;
  return seen_through ? Sight::empty : Sight::unknown;
}

}  // namespace surefoot::mapping
