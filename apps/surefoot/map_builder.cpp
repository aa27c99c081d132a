// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "map_builder.hpp"

#include <cmath>

namespace surefoot::app {

namespace {

std::uint64_t cube_key(const Eigen::Vector3d& point, double inverse_voxel) {
  constexpr std::uint64_t mask = (1U << 21) - 1;  // 21 bits an axis
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::int64_t>(std::floor(point[axis] * inverse_voxel));
    key = key << 21 | (static_cast<std::uint64_t>(index) & mask);
  }
  return key;
}

}  // namespace

void MapBuilder::add(const DeskewedScan& scan, const Pose& T_map_lidar, double seconds) {
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  if (scan.intensities.empty()) {
    has_intensities_ = false;
    intensities_.clear();
  }
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = R * scan.points[i].cast<double>() + T_map_lidar.translation;
    if (!taken_.insert(cube_key(point, inverse_voxel_)).second) continue;
    points_.push_back(point.cast<float>());
    first_seen_.push_back(static_cast<float>(seconds));
    if (has_intensities_) intensities_.push_back(scan.intensities[i]);
  }
}

}  // namespace surefoot::app
