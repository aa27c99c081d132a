// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/map_blur.hpp"

#include <cmath>

#include "geometry/decompositions.hpp"

namespace surefoot::checks {
namespace {

constexpr double kCell = 0.5;  // [m] much more than a scan is blurred by, less than walls are wide
constexpr double kLeastPoints = 20.0;
// Points of a scan that are asked for their distance; all are laid into the map.
constexpr std::size_t kAsked = 3000;

std::uint64_t key_of(const Eigen::Vector3d& point) {
  const Eigen::Array3d cell = (point.array() / kCell).floor();
  std::uint64_t key = 0;
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::int64_t>(cell[i]);
    key = (key << 21) | (static_cast<std::uint64_t>(index) & 0x1fffffU);
  }
  return key;
}

bool is_usable(const Eigen::Vector3d& point) {
  constexpr double kFarthest = 1e5;  // [m] of what has a cell of its own
  return point.allFinite() && point.cwiseAbs().maxCoeff() < kFarthest;
}

}  // namespace

std::optional<double> MapBlur::distance(const Eigen::Vector3d& point) const {
  const auto found = cells_.find(key_of(point));
  if (found == cells_.end() || found->second.count < kLeastPoints) return std::nullopt;
  const Moments& moments = found->second;
  const Eigen::Vector3d mean = moments.sum / moments.count;
  const Eigen::Matrix3d covariance = moments.squares / moments.count - mean * mean.transpose();
  const Eigen::Vector3d normal = symmetric_eigen_direct(covariance).vectors.col(0);
  return std::abs(normal.dot(point - mean));
}

std::optional<double> MapBlur::add(const std::vector<Eigen::Vector3f>& points,
                                   const Pose& T_world_lidar) {
  double sum = 0.0, count = 0.0;
  const std::size_t step = points.size() / kAsked + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Eigen::Vector3d point = T_world_lidar * points[i].cast<double>();
    if (!is_usable(point)) continue;
    if (const auto away = distance(point)) {
      sum += *away;
      count += 1.0;
    }
  }
  for (const Eigen::Vector3f& one : points) {
    const Eigen::Vector3d point = T_world_lidar * one.cast<double>();
    if (!is_usable(point)) continue;
    Moments& moments = cells_[key_of(point)];
    moments.count += 1.0;
    moments.sum += point;
    moments.squares += point * point.transpose();
  }
  constexpr double kLeastAsked = 100.0;
  return count >= kLeastAsked ? std::optional(sum / count) : std::nullopt;
}

}  // namespace surefoot::checks
