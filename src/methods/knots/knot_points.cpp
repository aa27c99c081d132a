// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/downsample.hpp"
#include "core/isolated.hpp"
#include "core/morton_order.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// With so many times the points wanted, the scan is thinned again at once.
constexpr double kFarTooMany = 2.0;

// More than so many times the points wanted are too many even if the cubes are the coarsest: of a
// dense sensor's scan, whose points say the same again.
constexpr double kMost = 4.0;

}  // namespace

std::vector<std::uint32_t> PointChoice::thin(const std::vector<Eigen::Vector3f>& places,
                                             const Workers& workers) {
  const double finest = std::min(cubes_.finest, cubes_.coarsest);
  for (int attempt = 1;; ++attempt) {
    std::vector<std::uint32_t> thinned = downsample_indices(places, voxel_, workers);
    const double excess = static_cast<double>(thinned.size()) / points_;
    const double coarsest = std::max(cubes_.coarsest, voxel_ * std::sqrt(excess / kMost));
    const double used =
        std::exchange(voxel_, std::clamp(voxel_ * std::sqrt(excess), finest, coarsest));
    if (attempt < 2 && excess > kFarTooMany && voxel_ > used) continue;
    sort_along_morton_curve(places, thinned);
    return thinned;
  }
}

std::vector<std::uint32_t> PointChoice::choose(const PreparedScan& scan, const Workers& workers) {
  return choose(scan, points_with_company(scan.points, workers), workers);
}

std::vector<std::uint32_t> PointChoice::choose(const PreparedScan& scan,
                                               const std::vector<std::uint32_t>& candidates,
                                               const Workers& workers) {
  std::vector<Eigen::Vector3f> places;
  places.reserve(candidates.size());
  for (const std::uint32_t i : candidates) places.push_back(scan.points[i]);
  std::vector<std::uint32_t> chosen = thin(places, workers);
  for (std::uint32_t& i : chosen) i = candidates[i];
  return chosen;
}

PointChoice map_choice(const Config::Knots& config) {
  const double coarsest = std::max(config.finest_voxel, config.map_voxel);
  return {config.map_points, {config.map_voxel, coarsest, coarsest}};
}

KnotPoints sort_points(const PreparedScan& scan, const std::vector<std::uint32_t>& chosen,
                       const KnotWindow& window) {
  const auto segments = window.segments();
  const double duration = seconds(scan.end_ns - scan.start_ns);
  const double offset = seconds(scan.start_ns - window.begin_ns);
  std::vector<std::vector<KnotPoints::Point>> sorted(segments);
  for (const std::uint32_t i : chosen) {
    const double tau = scan.taus.empty() ? 0.5 : static_cast<double>(scan.taus[i]);
    const double scaled = (offset + tau * duration) / window.step;
    const auto last = static_cast<double>(segments - 1);
    const auto segment = static_cast<std::size_t>(std::clamp(scaled, 0.0, last));
    sorted[segment].push_back(
        {scan.points[i].cast<double>(), scaled - static_cast<double>(segment), {}});
  }
  KnotPoints points;
  for (const auto& part : sorted) {
    points.begins.push_back(points.points.size());
    points.points.insert(points.points.end(), part.begin(), part.end());
  }
  points.begins.push_back(points.points.size());
  return points;
}

}  // namespace surefoot
