// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Integer coordinates of voxels and their packing into one 64-bit key.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace surefoot {

/// Voxel that holds a coordinate; floor, so that cells left and right of zero are equally large.
/// By truncation and a correction, since std::floor is a call where SSE4.1 may not be assumed.
/// The quotient must fit 32 bits.
[[nodiscard]] inline std::int32_t voxel_index(double coordinate, double inverse_size) {
  const double scaled = coordinate * inverse_size;
  const auto truncated = static_cast<std::int32_t>(scaled);
  return truncated - (static_cast<double>(truncated) > scaled ? 1 : 0);
}

using VoxelIndex = Eigen::Vector3i;

[[nodiscard]] inline VoxelIndex voxel_index(const Eigen::Vector3d& point, double inverse_size) {
  return {voxel_index(point.x(), inverse_size), voxel_index(point.y(), inverse_size),
          voxel_index(point.z(), inverse_size)};
}

/// Of the voxel twice as large that holds this one: rounded down.
[[nodiscard]] inline VoxelIndex coarser(const VoxelIndex& index) {
  return {index.x() >> 1, index.y() >> 1, index.z() >> 1};
}

/// 21 bits a coordinate: +-1,048,576 voxels each way before keys repeat.
[[nodiscard]] inline std::uint64_t voxel_key(const VoxelIndex& index) {
  constexpr std::uint64_t mask = (1U << 21) - 1;
  const auto bits = [](int value) { return static_cast<std::uint64_t>(value) & mask; };
  return bits(index.x()) << 42 | bits(index.y()) << 21 | bits(index.z());
}

/// Spreads keys over a table (the finaliser of splitmix64).
[[nodiscard]] inline std::uint64_t hash_key(std::uint64_t key) {
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebULL;
  return key ^ (key >> 31);
}

}  // namespace surefoot
