// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A small room as a local map and a scan of it, for tests of the registration's steps.
#pragma once

#include <vector>

#include "core/parallel.hpp"
#include "methods/paper/local_map.hpp"
#include "methods/paper/matches.hpp"
#include "support/default_parameters.hpp"
#include "support/random.hpp"

namespace surefoot::test {

/// Of a registration.
inline constexpr int kMinMatches = 20;

/// Parameters that the steps' tests rely on; the table's defaults do not matter to them.
inline PaperParameters step_config() {
  PaperParameters config = default_parameters<PaperParameters>();
  config.map.voxel_size = 1.0;
  config.map.points_per_voxel = 40;
  config.map.min_spacing = 0.05;
  config.registration.mode = RegistrationMode::decoupled;
  config.registration.target = TargetKind::point;
  config.registration.max_iterations = 50;
  config.registration.max_distance = 1.0;
  config.registration.relaxed_distance = 2.0;
  config.registration.early_iterations = 2;
  config.registration.convergence = 1e-5;
  config.horizontal.kernel_scale = 0.3;
  config.vertical.sub_iterations = 2;
  config.vertical.min_neighbours = 6;
  config.vertical.min_normal_z = 0.3;
  config.vertical.max_range = 50.0;
  config.vertical.near_distance = 5.0;
  config.vertical.distance_decay = 0.02;
  config.vertical.near_gate = 0.2;
  config.vertical.near_suppression = 0.05;
  config.vertical.kernel_scale = 0.15;
  config.vertical.trust_region = 0.2;
  return config;
}

/// Points spread over a face: corner + a * u + b * v with a, b in [0, 1).
inline void add_face(std::vector<Eigen::Vector3d>& points, Random& random, int count,
                     const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                     const Eigen::Vector3d& v) {
  for (int i = 0; i < count; ++i) {
    const double a = random.uniform(0.0, 1.0);
    points.emplace_back(corner + a * u + random.uniform(0.0, 1.0) * v);
  }
}

/// A room of 12 m x 8 m, floor at z = -0.5, four walls 3 m high, a sloped slab and a block. The
/// same seed gives the same points.
inline std::vector<Eigen::Vector3d> room_points(std::uint64_t seed, int per_face) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points;
  add_face(points, random, 2 * per_face, {-6, -4, -0.5}, {12, 0, 0}, {0, 8, 0});
  add_face(points, random, per_face, {-6, -4, -0.5}, {12, 0, 0}, {0, 0, 3});
  add_face(points, random, per_face, {-6, 4, -0.5}, {12, 0, 0}, {0, 0, 3});
  add_face(points, random, per_face, {-6, -4, -0.5}, {0, 8, 0}, {0, 0, 3});
  add_face(points, random, per_face, {6, -4, -0.5}, {0, 8, 0}, {0, 0, 3});
  add_face(points, random, per_face / 2, {2, -2, -0.5}, {3, 0, 1}, {0, 2, 0});
  add_face(points, random, per_face / 4, {-4, 1, -0.5}, {0.7, 0.7, 0}, {0, 0, 1.5});
  return points;
}

inline LocalMap make_map(const std::vector<Eigen::Vector3d>& points, const PaperParameters& config,
                         const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  // The registration may look a little beyond its correspondence distance.
  LocalMap map(config.map, config.registration.relaxed_distance + 1.0);
  for (const Eigen::Vector3d& point : points) map.insert(point + shift);
  return map;
}

/// Map points as the LiDAR at `T_map_lidar` sees them.
inline Source make_source(const std::vector<Eigen::Vector3d>& points, const Pose& T_map_lidar) {
  Source source;
  const Pose T_lidar_map = T_map_lidar.inverse();
  for (const Eigen::Vector3d& point : points) {
    source.points.emplace_back((T_lidar_map * point).cast<float>());
  }
  return source;
}

/// The nearest of `targets` within `max_distance`, for every source point seen from a pose.
inline void match_by_brute_force(Source& source, const std::vector<Eigen::Vector3d>& targets,
                                 const Pose& T_map_lidar, double max_distance) {
  source.matches.assign(source.points.size(), Match{});
  source.surfaces.assign(source.points.size(), CachedSurface{});
  for (std::size_t i = 0; i < source.points.size(); ++i) {
    const Eigen::Vector3d place = T_map_lidar * source.points[i].cast<double>();
    double best = max_distance;
    for (const Eigen::Vector3d& target : targets) {
      if ((target - place).norm() >= best) continue;
      best = (target - place).norm();
      source.matches[i].found = true;
      source.matches[i].target = target;
    }
  }
}

inline Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
  return m;
}

}  // namespace surefoot::test
