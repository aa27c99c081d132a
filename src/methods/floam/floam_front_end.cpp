// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/floam_front_end.hpp"

#include <algorithm>
#include <array>

#include "config/method.hpp"
#include "methods/floam/floam_features.hpp"
#include "methods/floam/mean_downsample.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr int kFirstOptimizations = 12;     // matchings of the scan after the first; one less for
constexpr int kLeastOptimizations = 2;      // every further scan, down to these
constexpr double kMaxNeighbour = 1.0;       // [m] all five neighbours are nearer than this
constexpr double kMapHalfSide = 100.0;      // [m] of the map's cube about the sensor
constexpr std::size_t kLeastMapEdges = 11;  // with fewer, a scan is not registered
constexpr std::size_t kLeastMapSurfaces = 51;

std::vector<Eigen::Vector3d> pick(const std::vector<Eigen::Vector3d>& points,
                                  const std::vector<std::uint32_t>& indices) {
  std::vector<Eigen::Vector3d> picked;
  picked.reserve(indices.size());
  for (const std::uint32_t index : indices) picked.push_back(points[index]);
  return picked;
}

/// Adds points, cuts the cloud to the cube about the sensor and thins it.
void extend(std::vector<Eigen::Vector3d>& cloud, const std::vector<Eigen::Vector3d>& points,
            const Eigen::Vector3d& sensor, double cell) {
  cloud.insert(cloud.end(), points.begin(), points.end());
  std::erase_if(cloud, [&](const Eigen::Vector3d& point) {
    return (point - sensor).lpNorm<Eigen::Infinity>() > kMapHalfSide;
  });
  cloud = mean_downsample(cloud, cell);
}

/// The five map points about a place, if they are near enough.
bool find_five(const KdTree& tree, const Eigen::Vector3d& place,
               std::array<Eigen::Vector3d, 5>& five) {
  std::array<KdTree::Neighbour, 5> found;
  if (tree.nearest(place, kMaxNeighbour, found) < found.size()) return false;
  for (std::size_t i = 0; i < five.size(); ++i) five[i] = tree.points()[found[i].index];
  return true;
}

}  // namespace

FloamFrontEnd::FloamFrontEnd(const Session& session)
    : BaselineFrontEnd(session),
      floam_(own_parameters<FloamParameters>(session.config)),
      optimization_count_(kFirstOptimizations) {}

Estimate FloamFrontEnd::add(const PreparedScan& scan) {
  begin_step(Step::deskew);
  const FloamFeatures features = extract_features(scan, floam_);
  const auto clouds_after = [&](const Twist& motion) {
    const std::vector<Eigen::Vector3d> points = deskew_to(0.5, scan, motion, workers());
    keep_scan(to_float(points), scan);
    return Clouds{pick(points, features.edges), pick(points, features.surfaces)};
  };
  const bool compensate = floam_.distortion_compensation;
  Twist motion = compensate ? se3_log(last_delta_) : Twist::Zero();
  const Clouds clouds = clouds_after(motion);
  if (!started() || map_.surfaces.empty()) {
    if (!started()) last_pose_ = first_pose(deskewed_scan().points);
    map_ = {transformed(last_pose_, clouds.edges), transformed(last_pose_, clouds.surfaces)};
    optimization_count_ = kFirstOptimizations;
    return report_first(constant_velocity_through(last_pose_, 0.5, motion, scan));
  }

  begin_step(Step::downsample);
  const Clouds source = thinned(clouds);
  begin_step(Step::search);
  const Alignment alignment = register_clouds(source, last_pose_ * last_delta_);
  last_delta_ = last_pose_.inverse() * alignment.T_map_lidar;
  last_pose_ = alignment.T_map_lidar;

  begin_step(Step::map);
  if (compensate) motion = se3_log(last_delta_);
  add_to_map(compensate ? thinned(clouds_after(motion)) : source, last_pose_);
  return report(alignment, constant_velocity_through(last_pose_, 0.5, motion, scan));
}

FloamFrontEnd::Clouds FloamFrontEnd::thinned(const Clouds& clouds) const {
  return {mean_downsample(clouds.edges, floam_.map_resolution),
          mean_downsample(clouds.surfaces, 2.0 * floam_.map_resolution)};
}

Alignment FloamFrontEnd::register_clouds(const Clouds& clouds, const Pose& prediction) {
  optimization_count_ = std::max(optimization_count_ - 1, kLeastOptimizations);
  Alignment result;
  result.T_map_lidar = prediction;
  result.points = static_cast<int>(clouds.edges.size() + clouds.surfaces.size());
  if (map_.edges.size() < kLeastMapEdges || map_.surfaces.size() < kLeastMapSurfaces) return result;
  const Trees trees{KdTree(map_.edges), KdTree(map_.surfaces)};
  for (int i = 0; i < optimization_count_; ++i) {
    const FloamSolution solution =
        solve_floam(match(clouds, trees, result.T_map_lidar), result.T_map_lidar, workers());
    result.T_map_lidar = solution.T_map_lidar;
    result.equations = solution.equations;
    result.iterations += solution.steps;
    result.converged = solution.converged;
  }
  return result;
}

/// Every feature's line or plane in the map, where there is one.
std::vector<FloamResidual> FloamFrontEnd::match(const Clouds& clouds, const Trees& trees,
                                                const Pose& T_map_lidar) const {
  const std::size_t edges = clouds.edges.size();
  std::vector<FloamResidual> all(edges + clouds.surfaces.size());
  std::vector<char> found(all.size(), 0);
  workers().for_chunks(all.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    std::array<Eigen::Vector3d, 5> five;
    for (std::size_t i = begin; i < end; ++i) {
      const bool edge = i < edges;
      all[i].point = edge ? clouds.edges[i] : clouds.surfaces[i - edges];
      if (!find_five(edge ? trees.edges : trees.surfaces, T_map_lidar * all[i].point, five)) {
        continue;
      }
      found[i] = edge ? fit_line(five, all[i]) : fit_plane(five, floam_.centred_planes, all[i]);
    }
  });
  std::vector<FloamResidual> residuals;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (found[i]) residuals.push_back(all[i]);
  }
  return residuals;
}

void FloamFrontEnd::add_to_map(const Clouds& clouds, const Pose& T_map_lidar) {
  const Eigen::Vector3d& sensor = T_map_lidar.translation;
  extend(map_.edges, transformed(T_map_lidar, clouds.edges), sensor, floam_.map_resolution);
  extend(map_.surfaces, transformed(T_map_lidar, clouds.surfaces), sensor,
         2.0 * floam_.map_resolution);
}

std::vector<Eigen::Vector3d> FloamFrontEnd::local_map() const {
  std::vector<Eigen::Vector3d> points = map_.edges;
  points.insert(points.end(), map_.surfaces.begin(), map_.surfaces.end());
  return points;
}

}  // namespace surefoot
