// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_builder.hpp"

#include <cmath>
#include <limits>

namespace surefoot::mapping {

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

bool MapBuilder::forgotten(std::size_t point) const {
  if (emptied_.empty()) return false;
  const auto found = emptied_.find(cube_key(points_[point].cast<double>(), inverse_side_));
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
    const auto [slot, fresh] = taken_.try_emplace(cube_key(point, inverse_voxel_), next);
    if (!fresh && !forgotten(slot->second)) continue;
    slot->second = next;
    points_.emplace_back(point.cast<float>());
    first_seen_.push_back(static_cast<float>(seconds));
    if (has_intensities_) intensities_.push_back(scan.intensities[i]);
  }
}

void MapBuilder::forget(const Cubes& cubes, double seconds) {
  if (cubes.centres.empty()) return;
  inverse_side_ = 1.0 / cubes.side;
  for (const Eigen::Vector3d& centre : cubes.centres) {
    emptied_[cube_key(centre, inverse_side_)] = static_cast<float>(seconds);
  }
}

void MapBuilder::correct(const std::function<Pose(double seconds)>& correction) {
  taken_.clear();
  std::size_t kept = 0;
  float time = std::numeric_limits<float>::quiet_NaN();  // points come scan by scan
  Pose moved;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (first_seen_[i] != time) {
      time = first_seen_[i];
      moved = correction(time);
    }
    const Eigen::Vector3d point = moved * points_[i].cast<double>();
    if (!taken_.try_emplace(cube_key(point, inverse_voxel_), 0U).second) continue;
    points_[kept] = point.cast<float>();
    first_seen_[kept] = first_seen_[i];
    if (has_intensities_) intensities_[kept] = intensities_[i];
    ++kept;
  }
  points_.resize(kept);
  first_seen_.resize(kept);
  if (has_intensities_) intensities_.resize(kept);
  taken_.clear();
}

void MapBuilder::drop_forgotten() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (forgotten(i)) continue;
    points_[kept] = points_[i];
    first_seen_[kept] = first_seen_[i];
    if (has_intensities_) intensities_[kept] = intensities_[i];
    ++kept;
  }
  points_.resize(kept);
  first_seen_.resize(kept);
  if (has_intensities_) intensities_.resize(kept);
  taken_.clear();
}

}  // namespace surefoot::mapping
