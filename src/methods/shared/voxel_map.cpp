// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/voxel_map.hpp"

#include <algorithm>

namespace surefoot {

const std::array<VoxelIndex, 27>& neighbour_shifts() {
  static const std::array<VoxelIndex, 27> shifts = [] {
    std::array<VoxelIndex, 27> all;
    std::size_t next = 0;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) all[next++] = {x, y, z};
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const VoxelIndex& a, const VoxelIndex& b) {
      return a.squaredNorm() < b.squaredNorm();
    });
    return all;
  }();
  return shifts;
}

namespace {

/// Squared distances from a query to the cells beside its own, per axis and shift (-1, 0, 1).
class CellGaps {
 public:
  CellGaps(const Eigen::Vector3d& query, const VoxelIndex& index,
           const VoxelMap::Options& options) {
    for (int axis = 0; axis < 3; ++axis) {
      const CellSpan span = cell_span(index[axis], options.voxel_size, options.rounding);
      gaps_[axis] = {squared(query[axis] - span.low), 0.0, squared(span.high - query[axis])};
    }
  }

  [[nodiscard]] double squared_distance(const VoxelIndex& shift) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      sum += gaps_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(shift[axis] + 1)];
    }
    return sum;
  }

 private:
  /// Rounding may put a point that lies on a border into the cell behind it.
  static double squared(double gap) {
    constexpr double kRounding = 1e-9;  // [m]
    const double sure = std::max(gap - kRounding, 0.0);
    return sure * sure;
  }

  std::array<std::array<double, 3>, 3> gaps_;
};

}  // namespace

std::span<const Eigen::Vector3d> VoxelMap::cell(const VoxelIndex& index) const {
  const std::uint32_t slot = table_.find(voxel_key(index));
  if (slot == VoxelTable::kNone) return {};
  return {points_.data() + first_point(slot), static_cast<std::size_t>(cells_[slot].count)};
}

void VoxelMap::insert(const Eigen::Vector3d& point) {
  const std::uint64_t key = voxel_key(index_of(point));
  const auto [slot, inserted] =
      table_.find_or_insert(key, static_cast<std::uint32_t>(cells_.size()));
  if (inserted) {
    cells_.push_back({key, 0});
    points_.resize(first_point(cells_.size()));
  }
  Cell& cell = cells_[slot];
  if (cell.count == options_.points_per_voxel) return;
  Eigen::Vector3d* first = points_.data() + first_point(slot);
  // Not squared: coordinates in whole millimetres give distances of exactly the spacing, and then
  // the rounding decides, as it does in the original.
  for (int i = 0; i < cell.count; ++i) {
    if ((first[i] - point).norm() < options_.min_spacing) return;
  }
  if (cell.count == 0) ++filled_;
  first[cell.count++] = point;
}

void VoxelMap::remove_far(const Eigen::Vector3d& sensor) {
  const double radius2 = options_.radius * options_.radius;
  for (std::size_t slot = 0; slot < cells_.size(); ++slot) {
    if (cells_[slot].count == 0) continue;
    if ((points_[first_point(slot)] - sensor).squaredNorm() < radius2) continue;
    cells_[slot].count = 0;
    --filled_;
  }
  if (2 * filled_ < cells_.size()) drop_empty_cells();
}

void VoxelMap::drop_empty_cells() {
  table_.clear();
  std::size_t kept = 0;
  for (std::size_t slot = 0; slot < cells_.size(); ++slot) {
    if (cells_[slot].count == 0) continue;
    if (slot != kept) {
      const auto from = points_.begin() + static_cast<std::ptrdiff_t>(first_point(slot));
      std::copy_n(from, cells_[slot].count,
                  points_.begin() + static_cast<std::ptrdiff_t>(first_point(kept)));
      cells_[kept] = cells_[slot];
    }
    table_.find_or_insert(cells_[kept].key, static_cast<std::uint32_t>(kept));
    ++kept;
  }
  cells_.resize(kept);
  points_.resize(first_point(kept));
}

const Eigen::Vector3d* VoxelMap::nearest(const Eigen::Vector3d& query, double max_distance) const {
  const VoxelIndex index = index_of(query);
  const CellGaps gaps(query, index, options_);
  const Eigen::Vector3d* best = nullptr;
  double best2 = max_distance * max_distance;
  for (const VoxelIndex& shift : neighbour_shifts()) {
    if (gaps.squared_distance(shift) >= best2) continue;  // nothing nearer in there
    for (const Eigen::Vector3d& point : cell(index + shift)) {
      const double distance2 = (point - query).squaredNorm();
      if (distance2 < best2) {
        best2 = distance2;
        best = &point;
      }
    }
  }
  return best;
}

std::vector<Eigen::Vector3d> VoxelMap::points() const {
  std::vector<Eigen::Vector3d> all;
  for (std::size_t slot = 0; slot < cells_.size(); ++slot) {
    const auto first = points_.begin() + static_cast<std::ptrdiff_t>(first_point(slot));
    all.insert(all.end(), first, first + cells_[slot].count);
  }
  return all;
}

}  // namespace surefoot
