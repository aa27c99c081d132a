// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/mean_downsample.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/voxel_table.hpp"
#include "methods/shared/cell_index.hpp"

namespace surefoot {

namespace {

struct CellMean {
  Eigen::Vector3d sum;
  int count;
};

}  // namespace

std::vector<Eigen::Vector3d> mean_downsample(const std::vector<Eigen::Vector3d>& points,
                                             double size) {
  VoxelTable table;
  std::vector<CellMean> means;
  for (const Eigen::Vector3d& point : points) {
    const VoxelIndex cell = cell_index(point, size, CellRounding::down);
    const auto next = static_cast<std::uint32_t>(means.size());
    const auto [slot, inserted] = table.find_or_insert(voxel_key(cell), next);
    if (inserted) {
      means.push_back({point, 1});
    } else {
      means[slot].sum += point;
      ++means[slot].count;
    }
  }
  std::vector<Eigen::Vector3d> thinned;
  thinned.reserve(means.size());
  for (const CellMean& mean : means) thinned.emplace_back(mean.sum / mean.count);
  return thinned;
}

}  // namespace surefoot
