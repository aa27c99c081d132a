// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/voxel_neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

/// Squared distance along one axis from a coordinate to the cells about its own.
class AxisGaps {
 public:
  static constexpr int kMaxReach = 8;

  AxisGaps(double coordinate, int index, int reach, const VoxelMap::Options& options) {
    for (int shift = -reach; shift <= reach; ++shift) {
      const CellSpan span = cell_span(index + shift, options.voxel_size, options.rounding);
      const double gap = std::max({span.low - coordinate, coordinate - span.high, 0.0});
      gaps_[static_cast<std::size_t>(shift + kMaxReach)] = gap * gap;
    }
  }

  [[nodiscard]] double operator[](int shift) const {
    return gaps_[static_cast<std::size_t>(shift + kMaxReach)];
  }

 private:
  std::array<double, 2 * kMaxReach + 1> gaps_;
};

}  // namespace

VoxelNeighbours::VoxelNeighbours(const VoxelMap& map, double radius, std::size_t count)
    : map_(map), radius2_(radius * radius), count_(count) {
  const double cells = std::ceil(radius / map.options().voxel_size);
  reach_ = static_cast<int>(std::min<double>(cells, AxisGaps::kMaxReach));
  for (int x = -reach_; x <= reach_; ++x) {
    for (int y = -reach_; y <= reach_; ++y) {
      for (int z = -reach_; z <= reach_; ++z) shifts_.push_back({x, y, z});
    }
  }
  std::stable_sort(shifts_.begin(), shifts_.end(), [](const VoxelIndex& a, const VoxelIndex& b) {
    return a.squaredNorm() < b.squaredNorm();
  });
}

void VoxelNeighbours::find(const Eigen::Vector3d& query, std::vector<Neighbour>& found) const {
  found.clear();
  const VoxelIndex index = map_.index_of(query);
  const AxisGaps x(query.x(), index.x(), reach_, map_.options());
  const AxisGaps y(query.y(), index.y(), reach_, map_.options());
  const AxisGaps z(query.z(), index.z(), reach_, map_.options());
  double bound2 = radius2_;
  for (const VoxelIndex& shift : shifts_) {
    if (x[shift.x()] + y[shift.y()] + z[shift.z()] > bound2) continue;  // nothing nearer in there
    for (const Eigen::Vector3d& point : map_.cell(index + shift)) {
      const double distance2 = (point - query).squaredNorm();
      if (distance2 > bound2) continue;
      if (found.size() == count_) {  // the farthest makes room
        std::pop_heap(found.begin(), found.end());
        found.back() = {distance2, &point};
      } else {
        found.push_back({distance2, &point});
      }
      std::push_heap(found.begin(), found.end());
      if (found.size() == count_) bound2 = found.front().distance2;
    }
  }
  std::sort_heap(found.begin(), found.end());
}

}  // namespace surefoot
