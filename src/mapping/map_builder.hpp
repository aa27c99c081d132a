// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mapping/cube_table.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::mapping {

/// The whole map of a run: every registered scan's deskewed points, one per cube, without those of
/// what moved away.
class MapBuilder {
 public:
  /// `voxel`: side of the cubes [m].
  explicit MapBuilder(double voxel) : voxel_(voxel), inverse_voxel_(1.0 / voxel) {}

  /// Adds a scan whose LiDAR stood at `T_world_lidar` at mid-scan, `seconds` after the first scan.
  void add(const DeskewedScan& scan, const Pose& T_world_lidar, double seconds);

  /// What was seen in these cubes before has moved away.
  void forget(const Cubes& cubes, double seconds);
  /// The points that are left of it, to be written: nothing can be added to them.
  [[nodiscard]] MapBuilder without_forgotten() const;

  /// With every point moved by the correction of the time when it was first seen [s], and one kept
  /// a cube: what was seen on two visits comes together. Without those of times that have none.
  [[nodiscard]] MapBuilder corrected(
      const std::function<std::optional<Pose>(double seconds)>& correction) const;

  [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /// Empty if any scan had no intensities.
  [[nodiscard]] const std::vector<float>& intensities() const { return intensities_; }
  /// When the scan was taken that put the point into the map [s after the first scan].
  [[nodiscard]] const std::vector<float>& first_seen() const { return first_seen_; }

 private:
  [[nodiscard]] bool forgotten(std::size_t point) const;

  double voxel_, inverse_voxel_;
  bool has_intensities_ = true;
  CubeTable taken_;                                   // by which point
  double inverse_side_ = 1.0;                         // [1/m] of the emptied cubes
  std::unordered_map<std::uint64_t, float> emptied_;  // when last [s]
  std::vector<Eigen::Vector3f> points_;               // [m] map frame
  std::vector<float> intensities_;
  std::vector<float> first_seen_;  // [s]
};

}  // namespace surefoot::mapping
