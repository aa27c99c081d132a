// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/piece_ground.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/voxel_key.hpp"

namespace surefoot::mapping {

namespace {

constexpr float kOut = 0.25F;   // [m] what stands is out of the ground by so much
constexpr float kAlike = 0.3F;  // [m] squares whose lowest points differ by less are alike
constexpr int kWide = 6;        // of the nine squares about a place: ground, not a car's side

VoxelIndex square_of(const Eigen::Vector3f& place) {
  return {voxel_index(static_cast<double>(place.x()), 1.0),
          voxel_index(static_cast<double>(place.y()), 1.0), 0};
}

}  // namespace

PieceGround::PieceGround(const Submap& submap)
    : R_slope_(submap.to_slope.toRotationMatrix().cast<float>()),
      ground_(static_cast<float>(submap.slope_ground)) {
  for (const Eigen::Vector3f& point : submap.points) {
    const Eigen::Vector3f at = R_slope_ * point;
    const auto next = static_cast<std::uint32_t>(lowest_.size());
    const auto [square, fresh] = squares_.find_or_insert(voxel_key(square_of(at)), next);
    if (fresh) lowest_.push_back(at.z());
    lowest_[square] = std::min(lowest_[square], at.z());
  }
}

bool PieceGround::stands(const Eigen::Vector3f& place) const {
  if (height(place) <= kOut) return false;
  const Eigen::Vector3f at = R_slope_ * place;
  const VoxelIndex square = square_of(at);
  std::array<float, 9> lowest{};
  for (int i = 0; i < 9; ++i) {
    const std::uint32_t known =
        squares_.find(voxel_key(square + VoxelIndex(i / 3 - 1, i % 3 - 1, 0)));
    lowest[static_cast<std::size_t>(i)] =
        known == VoxelTable::kNone ? std::numeric_limits<float>::max() : lowest_[known];
  }
  const float ground = *std::min_element(lowest.begin(), lowest.end());
  if (at.z() > ground + kOut) return true;
  return std::count_if(lowest.begin(), lowest.end(),
                       [&](float low) { return low < ground + kAlike; }) < kWide;
}

}  // namespace surefoot::mapping
