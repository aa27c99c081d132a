// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/thin_scan.hpp"

#include "core/downsample.hpp"

namespace surefoot {

ThinnedScan thin_scan(const std::vector<Eigen::Vector3f>& points,
                      const PaperParameters::Downsample& config, const Workers& workers) {
  constexpr double kFinest = 1.0 / 16.0;  // of the cubes that were asked for
  const auto enough = static_cast<std::size_t>(config.min_points);
  for (double scale = 1.0;; scale *= 0.5) {
    ThinnedScan thinned;
    thinned.map_points = downsample(points, scale * config.map_voxel, workers);
    thinned.source_points = downsample(thinned.map_points, scale * config.source_voxel, workers);
    if (thinned.source_points.size() >= enough || scale <= kFinest) return thinned;
  }
}

}  // namespace surefoot
