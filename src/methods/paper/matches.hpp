// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the registration stages share: the scan being registered, its matches, and jacobians about
// the sensor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/so3.hpp"
#include "methods/paper/local_map.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// A source point's partner in the map.
struct Match {
  bool found = false;
  Eigen::Vector3d target = Eigen::Vector3d::Zero();  ///< q_i, map frame [m]
};

/// The last search around a source point. Its answer stays known while the point hardly moves.
struct CachedSearch {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< where the point was, map frame [m]
  Nearby nearby;                                    ///< clearance 0: nothing is known yet
};

/// The map's surface around a source point, kept as long as the point stays in its voxel.
struct CachedSurface {
  bool known = false;
  VoxelIndex voxel = VoxelIndex::Zero();
  Surface surface;
};

/// The scan being registered: points at mid-scan, LiDAR frame [m], and per point its match and what
/// is known around it.
struct Source {
  std::vector<Eigen::Vector3f> points;
  std::vector<Match> matches;
  std::vector<CachedSearch> searches;
  std::vector<CachedSurface> surfaces;
};

/// A match seen from the sensor: map axes, origin at the sensor's present position.
///
/// The paper writes its jacobians with s_i in map coordinates. A rotation update about the map's
/// origin then moves the sensor by its distance from there: far from the start, yaw and
/// translation become nearly the same column. About the sensor they stay apart, anywhere.
struct SensorMatch {
  Eigen::Vector3d s;  ///< source point
  Eigen::Vector3d q;  ///< its target
};

[[nodiscard]] inline SensorMatch about_sensor(const Eigen::Matrix3d& R_map_lidar,
                                              const Eigen::Vector3d& sensor,
                                              const Eigen::Vector3f& point, const Match& match) {
  return {R_map_lidar * point.cast<double>(), match.target - sensor};
}

/// Point-to-point jacobian [I | -[s]_x], eq. (14), s about the sensor.
[[nodiscard]] inline Eigen::Matrix<double, 3, 6> point_jacobian(const Eigen::Vector3d& s) {
  Eigen::Matrix<double, 3, 6> J;  // [Eq 14]
  J.leftCols<3>().setIdentity();
  J.rightCols<3>() = -hat(s);
  return J;
}

/// Point-to-plane jacobian [n^T | n^T (-[s]_x)], eq. (24), s about the sensor.
[[nodiscard]] inline Eigen::Matrix<double, 1, 6> plane_jacobian(const Eigen::Vector3d& s,
                                                                const Eigen::Vector3d& n) {
  Eigen::Matrix<double, 1, 6> J;  // [Eq 24]
  J.leftCols<3>() = n.transpose();
  J.rightCols<3>() = s.cross(n).transpose();  // n^T (-[s]_x) = (s x n)^T
  return J;
}

/// exp(delta) * T, taken about the sensor's present position.
[[nodiscard]] inline Pose apply_update(const Pose& T_map_lidar, const Twist& delta) {
  const Pose step = se3_exp(delta);
  return {(step.rotation * T_map_lidar.rotation).normalized(),
          T_map_lidar.translation + step.translation};
}

/// The surface around source point i at its present place; looked up anew when it changed voxel.
[[nodiscard]] inline const Surface& surface_at(const LocalMap& map, const Eigen::Vector3d& place,
                                               CachedSurface& cached) {
  const VoxelIndex voxel = map.voxel_of(place);
  if (!cached.known || cached.voxel != voxel) cached = {true, voxel, map.surface(voxel)};
  return cached.surface;
}

}  // namespace surefoot
