// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/downsample.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"

namespace surefoot {

namespace {

struct Candidate {
  std::uint64_t key;  // of its voxel, hashed
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
  return {hash_key(voxel_key(index)), (point - centre.cast<float>()).squaredNorm(), point, at};
}

// The voxels are dealt into so many parts, by their keys' first bits, for as many threads.
constexpr int kPartBits = 2;
constexpr std::size_t kParts = 1 << kPartBits;

/// The best candidate of each voxel of one part, in the order of the keys.
std::vector<Candidate> best_of_part(const std::vector<Candidate>& candidates, std::size_t part) {
  VoxelTable table;
  std::vector<Candidate> kept;
  for (const Candidate& candidate : candidates) {
    if (candidate.key >> (64 - kPartBits) != part) continue;
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
  std::sort(kept.begin(), kept.end(),
            [](const Candidate& a, const Candidate& b) { return a.key < b.key; });
  return kept;
}

}  // namespace

std::vector<std::uint32_t> downsample_indices(const std::vector<Eigen::Vector3f>& points,
                                              double voxel, const Workers& workers) {
  std::vector<Candidate> candidates(points.size());
  workers.for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      candidates[i] = make_candidate(points, static_cast<std::uint32_t>(i), voxel);
    }
  });
  std::array<std::vector<Candidate>, kParts> parts;
  workers.for_each(kParts, [&](std::size_t p) { parts[p] = best_of_part(candidates, p); });
  std::vector<std::uint32_t> indices;
  for (const auto& part : parts) {
    for (const Candidate& candidate : part) indices.push_back(candidate.index);
  }
  return indices;
}

std::vector<Eigen::Vector3f> downsample(const std::vector<Eigen::Vector3f>& points, double voxel,
                                        const Workers& workers) {
  std::vector<Eigen::Vector3f> thinned;
  for (const std::uint32_t i : downsample_indices(points, voxel, workers)) {
    thinned.push_back(points[i]);
  }
  return thinned;
}

}  // namespace surefoot
