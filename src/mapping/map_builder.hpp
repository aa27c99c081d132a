// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mapping/cube_table.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::mapping {

/// The whole map of a run: every registered scan's deskewed points, one per cube, without those of
/// what moved away. Frames that nothing joins lie over each other, and leave each other's points
/// alone.
class MapBuilder {
 public:
  /// When a scan was taken [ns after the first one], and in which frame it stands.
  struct When {
    std::int64_t after_ns = 0;
    std::size_t frame = 0;
  };
  /// Where what was seen in a scan belongs, and in which frame that is.
  struct Correction {
    Pose pose;
    std::size_t frame = 0;
  };

  /// `voxel`: side of the cubes [m].
  explicit MapBuilder(double voxel) : voxel_(voxel), inverse_voxel_(1.0 / voxel) {}

  /// Adds a scan whose LiDAR stood at `T_world_lidar` at mid-scan.
  void add(const DeskewedScan& scan, const Pose& T_world_lidar, const When& when);

  /// What was seen in these cubes of its frame before has moved away.
  void forget(const Cubes& cubes, const When& when);
  /// The points that are left of it, to be written: nothing can be added to them.
  [[nodiscard]] MapBuilder without_forgotten() const;

  /// With every point moved by the correction of the time when it was first seen, and one kept a
  /// cube: what was seen on two visits comes together. Without those of times that have none.
  [[nodiscard]] MapBuilder corrected(
      const std::function<std::optional<Correction>(std::int64_t after_ns)>& correction) const;

  [[nodiscard]] const std::vector<Eigen::Vector3f>& points() const { return points_; }
  /// Empty if any scan had no intensities.
  [[nodiscard]] const std::vector<float>& intensities() const { return intensities_; }
  /// When the scan was taken that put the point into the map [s after the first scan].
  [[nodiscard]] const std::vector<float>& first_seen() const { return first_seen_; }

  /// The same of each point, to the nanosecond [ns].
  [[nodiscard]] std::vector<std::int64_t> first_seen_ns() const;

 private:
  struct Frame {
    CubeTable taken;                                   // by which point
    std::unordered_map<std::uint64_t, float> emptied;  // when last [s]
  };
  /// Points from this one on are of one scan, up to the next one's.
  struct Scan {
    std::size_t first_point = 0;
    When when;
  };

  [[nodiscard]] bool forgotten(const Frame& frame, std::size_t point) const;
  /// For good; what is left keeps its order.
  void drop_forgotten();
  /// Calls `use(i, scan)` with each point, as they came.
  template <typename Use>
  void for_points(const Use& use) const;

  double voxel_, inverse_voxel_;
  bool has_intensities_ = true;
  double inverse_side_ = 1.0;  // [1/m] of the emptied cubes
  std::map<std::size_t, Frame> frames_;
  std::vector<Scan> scans_;
  std::vector<Eigen::Vector3f> points_;  // [m] their frame
  std::vector<float> intensities_;
  std::vector<float> first_seen_;  // [s]
  std::size_t replaced_ = 0;       // points whose cubes are other points' by now
};

}  // namespace surefoot::mapping
