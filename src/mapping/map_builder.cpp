// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_builder.hpp"

#include <limits>

namespace surefoot::mapping {

bool MapBuilder::forgotten(std::size_t point) const {
  if (emptied_.empty()) return false;
  const auto found =
      emptied_.find(voxel_key(voxel_index(points_[point].cast<double>(), inverse_side_)));
  return found != emptied_.end() && first_seen_[point] < found->second;
}

void MapBuilder::add(const DeskewedScan& scan, const Pose& T_world_lidar, double seconds) {
  const Eigen::Matrix3d R = T_world_lidar.rotation.toRotationMatrix();
  if (scan.intensities.empty()) {
    has_intensities_ = false;
    intensities_.clear();
  }
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = R * scan.points[i].cast<double>() + T_world_lidar.translation;
    const auto next = static_cast<std::uint32_t>(points_.size());
    std::uint32_t& taken_by = taken_.at(voxel_index(point, inverse_voxel_));
    if (taken_by != CubeTable::kNone && !forgotten(taken_by)) continue;
    taken_by = next;
    points_.emplace_back(point.cast<float>());
    first_seen_.push_back(static_cast<float>(seconds));
    if (has_intensities_) intensities_.push_back(scan.intensities[i]);
  }
}

void MapBuilder::forget(const Cubes& cubes, double seconds) {
  if (cubes.centres.empty()) return;
  inverse_side_ = 1.0 / cubes.side;
  for (const Eigen::Vector3d& centre : cubes.centres) {
    emptied_[voxel_key(voxel_index(centre, inverse_side_))] = static_cast<float>(seconds);
  }
}

MapBuilder MapBuilder::corrected(
    const std::function<std::optional<Pose>(double seconds)>& correction) const {
  MapBuilder moved(voxel_);
  moved.has_intensities_ = has_intensities_;
  float time = std::numeric_limits<float>::quiet_NaN();  // points come scan by scan
  std::optional<Pose> by;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (first_seen_[i] != time) {
      time = first_seen_[i];
      by = correction(time);
    }
    if (!by) continue;
    const Eigen::Vector3d point = *by * points_[i].cast<double>();
    std::uint32_t& taken_by = moved.taken_.at(voxel_index(point, inverse_voxel_));
    if (taken_by != CubeTable::kNone) continue;
    taken_by = static_cast<std::uint32_t>(moved.points_.size());
    moved.points_.emplace_back(point.cast<float>());
    moved.first_seen_.push_back(time);
    if (has_intensities_) moved.intensities_.push_back(intensities_[i]);
  }
  return moved;
}

MapBuilder MapBuilder::without_forgotten() const {
  MapBuilder left(voxel_);
  left.has_intensities_ = has_intensities_;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (forgotten(i)) continue;
    left.points_.push_back(points_[i]);
    left.first_seen_.push_back(first_seen_[i]);
    if (has_intensities_) left.intensities_.push_back(intensities_[i]);
  }
  return left;
}

}  // namespace surefoot::mapping
