// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "surefoot/odometry.hpp"

namespace surefoot::app {

/// The whole map of a run: every registered scan's deskewed points, one per cube.
class MapBuilder {
 public:
  /// `voxel`: side of the cubes [m].
  explicit MapBuilder(double voxel) : inverse_voxel_(1.0 / voxel) {}

  /// Adds a scan whose LiDAR stood at `T_map_lidar` at mid-scan, `seconds` after the first scan.
  void add(const DeskewedScan& scan, const Pose& T_map_lidar, double seconds);

  [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /// Empty if any scan had no intensities.
  [[nodiscard]] const std::vector<float>& intensities() const { return intensities_; }
  /// When the scan was taken that put the point into the map [s after the first scan].
  [[nodiscard]] const std::vector<float>& first_seen() const { return first_seen_; }

 private:
  double inverse_voxel_;
  bool has_intensities_ = true;
  std::unordered_set<std::uint64_t> taken_;
  std::vector<Eigen::Vector3f> points_;  // [m] map frame
  std::vector<float> intensities_;
  std::vector<float> first_seen_;  // [s]
};

}  // namespace surefoot::app
