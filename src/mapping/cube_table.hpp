// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/pages.hpp"
#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"

namespace surefoot::mapping {

/// From millions of cubes that lie side by side to an index each: one search finds a block of
/// 4 x 4 x 4 of them, which the next points lie in, too; and as the table grows, only blocks are
/// put in order anew.
class CubeTable {
 public:
  static constexpr std::uint32_t kNone = VoxelTable::kNone;

  /// What is stored for a cube, to be read and set; kNone if nothing was.
  [[nodiscard]] std::uint32_t& at(const VoxelIndex& cube) {
    const VoxelIndex block(cube.x() >> kBits, cube.y() >> kBits, cube.z() >> kBits);
    const auto next = static_cast<std::uint32_t>(blocks_.size());
    const auto [found, fresh] = table_.find_or_insert(voxel_key(block), next);
    if (fresh) blocks_.add().fill(kNone);
    const VoxelIndex within = cube - block * (1 << kBits);
    return blocks_[found][within.x() << 2 * kBits | within.y() << kBits | within.z()];
  }

  /// Calls `use(stored)` with what is stored for each cube, kNone among it.
  template <typename Use>
  void for_all(const Use& use) {
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      for (std::uint32_t& stored : blocks_[block]) use(stored);
    }
  }

 private:
  static constexpr int kBits = 2;  // of a cube's index within its block

  VoxelTable table_;
  Pages<std::array<std::uint32_t, 1 << 3 * kBits>> blocks_;
};

}  // namespace surefoot::mapping
