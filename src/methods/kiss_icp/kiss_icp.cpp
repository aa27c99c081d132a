// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/kiss_icp/kiss_icp.hpp"

#include "methods/shared/cell_downsample.hpp"
#include "methods/shared/constant_velocity.hpp"

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr double kMapVoxels = 0.5;     // thinning of what enters the map, in voxels of the map
constexpr double kSourceVoxels = 1.5;  // thinning of what is registered
constexpr double kSearchSigmas = 3.0;  // correspondence distance, in adaptive thresholds

/// std::hash<kiss_icp::Voxel>: decides in which order the thinned points come.
std::uint32_t kiss_hash(const VoxelIndex& cell) {
  return (static_cast<std::uint32_t>(cell.x()) * 73856093U) ^
         (static_cast<std::uint32_t>(cell.y()) * 19349669U) ^
         (static_cast<std::uint32_t>(cell.z()) * 83492791U);
}

/// Moves the source by the last update, matches it and sums the equations of the next.
NormalEquations<6> build_linear_system(std::vector<Eigen::Vector3d>& source, const Pose& update,
                                       const VoxelMap& map, double sigma, const Workers& workers) {
  const Eigen::Matrix3d R = update.rotation.toRotationMatrix();
  return workers
      .sum<PointToPointSum>(source.size(),
                            [&](std::size_t begin, std::size_t end) {
                              PointToPointSum sum;
                              for (std::size_t i = begin; i < end; ++i) {
                                source[i] = R * source[i] + update.translation;
                                const Eigen::Vector3d* target =
                                    map.nearest(source[i], kSearchSigmas * sigma);
                                if (!target) continue;
                                const double residual2 = (source[i] - *target).squaredNorm();
                                sum.add(source[i], *target, geman_mcclure_weight(residual2, sigma));
                              }
                              return sum;
                            })
      .equations();
}

}  // namespace

KissClouds voxelize(const std::vector<Eigen::Vector3d>& points, double voxel_size) {
  KissClouds clouds;
  clouds.frame_downsample =
      cell_downsample(points, kMapVoxels * voxel_size, CellRounding::down, kiss_hash);
  clouds.source = cell_downsample(clouds.frame_downsample, kSourceVoxels * voxel_size,
                                  CellRounding::down, kiss_hash);
  return clouds;
}

Alignment align_points_to_map(const std::vector<Eigen::Vector3d>& source, const VoxelMap& map,
                              const Pose& initial_guess, double sigma,
                              const KissIcpParameters& config, const Workers& workers) {
  return align(source, initial_guess, config.max_num_iterations, config.convergence_criterion,
               [&](std::vector<Eigen::Vector3d>& moved, const Pose& update) {
                 return build_linear_system(moved, update, map, sigma, workers);
               });
}

}  // namespace surefoot
