// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/signed_distance.hpp"

#include <cmath>
#include <limits>

namespace surefoot::mapping {

namespace {

// In cells. All corners of a cell that a surface goes through lie within its diagonal, 1.73.
constexpr double kFarthest = 1.75;  // along the normal
constexpr double kAside = 1.5;      // across it: how far a surface goes on from a point
// Near surfaces outdo far ones, so that a wall's two faces do not become one, and near points outdo
// what goes on from others, so that an edge is hardly rounded.
constexpr double kSharp = 0.6;
constexpr double kSharpAside = 0.5;

// [m] A surface that lies on corners would by the last bits be before some and behind others.
constexpr double kOnIt = 1e-4;

}  // namespace

void SignedDistance::add(const OrientedPoint& point) {
  const Eigen::Vector3d at = point.place / cell_;
  const VoxelIndex low = voxel_index(at - Eigen::Vector3d::Constant(kFarthest), 1.0);
  const VoxelIndex high = voxel_index(at + Eigen::Vector3d::Constant(kFarthest), 1.0);
  for (int x = low.x() + 1; x <= high.x(); ++x) {
    for (int y = low.y() + 1; y <= high.y(); ++y) {
      for (int z = low.z() + 1; z <= high.z(); ++z) {
        const VoxelIndex corner(x, y, z);
        const Eigen::Vector3d from_point = corner.cast<double>() - at;
        const double before = point.normal.dot(from_point);
        const double aside2 = from_point.squaredNorm() - before * before;
        if (std::abs(before) > kFarthest || aside2 > kAside * kAside) continue;
        const auto next = static_cast<std::uint32_t>(sums_.size());
        const auto [found, fresh] = table_.find_or_insert(voxel_key(corner), next);
        if (fresh) {
          sums_.emplace_back();
          corners_.push_back(corner);
        }
        const double weight = std::exp(
            -0.5 * (aside2 / (kSharpAside * kSharpAside) + before * before / (kSharp * kSharp)));
        sums_[found].distance += static_cast<float>(weight * before * cell_);
        sums_[found].weight += static_cast<float>(weight);
      }
    }
  }
}

double SignedDistance::at(const VoxelIndex& corner) const {
  const std::uint32_t found = table_.find(voxel_key(corner));
  if (found == VoxelTable::kNone) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(sums_[found].distance / sums_[found].weight) - kOnIt;
}

}  // namespace surefoot::mapping
