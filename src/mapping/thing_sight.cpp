// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/thing_sight.hpp"

#include <array>
#include <limits>

namespace surefoot::mapping {

namespace {

constexpr BeamFineness kOfThings{0.3, 15.0F, 0.6F, std::numeric_limits<std::size_t>::max()};
constexpr double kThingCubesPerMetre = 1.0 / kOfThings.cube;  // [1/m]
constexpr int kBits = 2;                                      // of a cube's index within its block
constexpr int kCubes = 1 << 3 * kBits;

std::uint64_t block_of(const VoxelIndex& cube) {
  return voxel_key({cube.x() >> kBits, cube.y() >> kBits, cube.z() >> kBits});
}

int within_block(const VoxelIndex& cube) {
  constexpr int kMask = (1 << kBits) - 1;
  return (cube.x() & kMask) << 2 * kBits | (cube.y() & kMask) << kBits | (cube.z() & kMask);
}

std::uint64_t bit_of(int cube) { return std::uint64_t{1} << cube; }

}  // namespace

ThingSight::ThingSight(const Submap& submap,
                       const std::function<bool(const Eigen::Vector3f& point)>& stands) {
  std::vector<std::array<std::uint8_t, kCubes>> passes;  // of each block, while they are counted
  std::uint64_t last_key = ~0ULL;  // a beam's next cube mostly lies in the same block
  std::uint32_t last = 0;
  const auto block = [&](const VoxelIndex& cube) {
    const std::uint64_t key = block_of(cube);
    if (key == last_key) return last;
    const auto [index, fresh] =
        table_.find_or_insert(key, static_cast<std::uint32_t>(passes.size()));
    if (fresh) passes.push_back({});
    last_key = key;
    return last = index;
  };
  follow_beams(submap, kOfThings, [&](const VoxelIndex& cube) {
    std::uint8_t& count = passes[block(cube)][static_cast<std::size_t>(within_block(cube))];
    if (count < kEnoughBeams) ++count;
  });
  for (const Eigen::Vector3f& point : submap.points) {
    if (!stands(point)) continue;
    const VoxelIndex cube = voxel_index(point.cast<double>(), kThingCubesPerMetre);
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const VoxelIndex about =
          cube + VoxelIndex(neighbour / 9 - 1, neighbour / 3 % 3 - 1, neighbour % 3 - 1);
      const std::uint32_t index = block(about);
      if (index >= blocks_.size()) blocks_.resize(index + 1);
      blocks_[index].occupied |= bit_of(within_block(about));
    }
  }
  blocks_.resize(passes.size());
  blocks_.shrink_to_fit();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    for (int cube = 0; cube < kCubes; ++cube) {
      const bool through = passes[i][static_cast<std::size_t>(cube)] >= kEnoughBeams;
      if (through) blocks_[i].empty |= bit_of(cube);
    }
  }
}

FreeSpace::Sight ThingSight::at(const Eigen::Vector3d& place) const {
  const VoxelIndex cube = voxel_index(place, kThingCubesPerMetre);
  const std::uint32_t index = table_.find(block_of(cube));
  if (index == VoxelTable::kNone) return FreeSpace::Sight::unknown;
  const std::uint64_t bit = bit_of(within_block(cube));
  if ((blocks_[index].occupied & bit) != 0) return FreeSpace::Sight::occupied;
  return (blocks_[index].empty & bit) != 0 ? FreeSpace::Sight::empty : FreeSpace::Sight::unknown;
}

}  // namespace surefoot::mapping
