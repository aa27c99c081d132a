// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/parallel.hpp"
#include "methods/genz_icp/genz_icp_parameters.hpp"
#include "methods/shared/alignment.hpp"
#include "methods/shared/voxel_map.hpp"

namespace surefoot {

/// GenZ-ICP's adaptive threshold: as KISS-ICP's, but nothing is learnt while the sensor is near its
/// start, and the first deviation learnt replaces the initial one.
class GenzThreshold {
 public:
  explicit GenzThreshold(const GenzIcpParameters& config) : config_(config) {}

  /// `moved`: whether the sensor has left its start. Counts the last deviation if it has.
  [[nodiscard]] double threshold(bool moved);
  void set_deviation(const Pose& deviation) { deviation_ = deviation; }

 private:
  const GenzIcpParameters& config_;
  double squares_ = 0.0;
  int samples_ = 0;
  Pose deviation_;
};

/// The two thinned clouds, and the cell that gives about the desired number of registered points.
struct GenzClouds {
  std::vector<Eigen::Vector3d> frame_downsample;  ///< enters the map
  std::vector<Eigen::Vector3d> source;            ///< registered
  double voxel_size;                              ///< [m] of `source`; the next scan begins with it
};
[[nodiscard]] GenzClouds adaptive_voxelize(const std::vector<Eigen::Vector3d>& points,
                                           double voxel_size, const GenzIcpParameters& config);

[[nodiscard]] CellRounding cell_rounding(const GenzIcpParameters& config);

/// What the map is like about a place.
struct Planarity {
  bool planar = false;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};
/// From all points in a cell and its 26 neighbours.
[[nodiscard]] Planarity planarity(const VoxelMap& map, const VoxelIndex& cell,
                                  double planarity_threshold);

/// GenZ-ICP's registration: point to plane where the map is planar, point to point elsewhere, the
/// two weighted by their numbers; Geman-McClure weighted with scale sigma / 3, matches up to 3
/// sigma apart.
[[nodiscard]] Alignment align_genz(const std::vector<Eigen::Vector3d>& source, const VoxelMap& map,
                                   const Pose& initial_guess, double sigma,
                                   const GenzIcpParameters& config, const Workers& workers);

}  // namespace surefoot
