// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "odometry/downsample.hpp"

#include <algorithm>
#include <tuple>

#include "odometry/voxel_key.hpp"
#include "odometry/voxel_table.hpp"

namespace surefoot {

namespace {

struct Candidate {
  std::uint64_t key;
  float to_centre2;
  Eigen::Vector3f point;
  std::uint32_t index;  // of the point

  /// Total order, so that equally near points do not make the result depend on their order.
  [[nodiscard]] bool better_than(const Candidate& other) const {
    const auto rank = [](const Candidate& c) {
      return std::make_tuple(c.to_centre2, c.point.x(), c.point.y(), c.point.z());
    };
    return rank(*this) < rank(other);
  }
};

Candidate make_candidate(const std::vector<Eigen::Vector3f>& points, std::uint32_t at,
                         double voxel) {
  const Eigen::Vector3f& point = points[at];
  const VoxelIndex index = voxel_index(point.cast<double>(), 1.0 / voxel);
  const Eigen::Vector3d centre = (index.cast<double>().array() + 0.5) * voxel;
  return {voxel_key(index), (point - centre.cast<float>()).squaredNorm(), point, at};
}

}  // namespace

std::vector<std::uint32_t> downsample_indices(const std::vector<Eigen::Vector3f>& points,
                                              double voxel) {
  VoxelTable table;
  std::vector<Candidate> kept;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Candidate candidate = make_candidate(points, i, voxel);
    const auto next = static_cast<std::uint32_t>(kept.size());
    const auto [slot, inserted] = table.find_or_insert(candidate.key, next);
    if (inserted) {
      kept.push_back(candidate);
    } else if (candidate.better_than(kept[slot])) {
      kept[slot] = candidate;
    }
  }
  // Any fixed order will do, but a spatial one: a voxel of the map takes the first points it is
  // offered, and would fill up from one side, which pulls every later scan to that side.
  std::sort(kept.begin(), kept.end(), [](const Candidate& a, const Candidate& b) {
    return hash_key(a.key) < hash_key(b.key);
  });
  std::vector<std::uint32_t> indices;
  indices.reserve(kept.size());
  for (const Candidate& candidate : kept) indices.push_back(candidate.index);
  return indices;
}

std::vector<Eigen::Vector3f> downsample(const std::vector<Eigen::Vector3f>& points, double voxel) {
  std::vector<Eigen::Vector3f> thinned;
  for (const std::uint32_t i : downsample_indices(points, voxel)) thinned.push_back(points[i]);
  return thinned;
}

ThinnedScan thin_scan(const std::vector<Eigen::Vector3f>& points,
                      const Config::Downsample& config) {
  constexpr double kFinest = 1.0 / 16.0;
  const auto enough = static_cast<std::size_t>(config.min_points);
  for (double scale = 1.0;; scale *= 0.5) {
    ThinnedScan thinned;
    thinned.map_points = downsample(points, scale * config.map_voxel);
    thinned.source_points = downsample(thinned.map_points, scale * config.source_voxel);
    if (thinned.source_points.size() >= enough || scale <= kFinest) return thinned;
  }
}

}  // namespace surefoot
