// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/decompositions.hpp"

namespace surefoot {

namespace {

/// The keypoints' residuals, the first max_num_residuals of them.
std::vector<CtIcpResidual> match_all(const std::vector<CtIcpPoint>& keypoints,
                                     const VoxelNeighbours& neighbours, const CtIcpFrame& frame,
                                     const CtIcpParameters& config, const Workers& workers) {
  const CtIcpMotion motion(frame);
  std::vector<std::optional<CtIcpResidual>> all(keypoints.size());
  workers.for_chunks(keypoints.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d placed = motion.place(keypoints[i].alpha, keypoints[i].point);
      all[i] = match_ct_icp(keypoints[i], placed, neighbours, config);
    }
  });
  const std::size_t most = config.max_num_residuals > 0
                               ? static_cast<std::size_t>(config.max_num_residuals)
                               : keypoints.size();
  std::vector<CtIcpResidual> residuals;
  for (const std::optional<CtIcpResidual>& residual : all) {
    if (residual && residuals.size() < most) residuals.push_back(*residual);
  }
  return residuals;
}

/// Whether an iteration has moved neither pose.
bool is_still(const CtIcpFrame& before, const CtIcpFrame& after, const CtIcpParameters& config) {
  const double way = (after.begin.translation - before.begin.translation).norm() +
                     (after.end.translation - before.end.translation).norm();
  const double turn =
      degrees_between(before.begin, after.begin) + degrees_between(before.end, after.end);
  return turn < config.threshold_orientation_norm && way < config.threshold_translation_norm;
}

bool all_finite(const CtIcpFrame& frame) {
  return frame.begin.translation.allFinite() && frame.begin.rotation.coeffs().allFinite() &&
         frame.end.translation.allFinite() && frame.end.rotation.coeffs().allFinite();
}

}  // namespace

CtIcpPlane fit_ct_icp_plane(std::span<const VoxelNeighbours::Neighbour> neighbours) {
  const auto count = static_cast<double>(neighbours.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& neighbour : neighbours) mean += *neighbour.point;
  mean /= count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& neighbour : neighbours) {
    const Eigen::Vector3d off = *neighbour.point - mean;
    covariance.noalias() += off * off.transpose();
  }
  const SymmetricEigen<3> eigen = symmetric_eigen<3>(covariance / count);
  const Eigen::Vector3d spread = eigen.values.cwiseAbs().cwiseSqrt();
  const bool apart = spread[2] > 0.0;
  return {eigen.vectors.col(0), apart ? (spread[1] - spread[0]) / spread[2] : 0.0};
}

double ct_icp_weight(double planarity, double distance, const CtIcpParameters& config) {
  const double sum = config.weight_alpha + config.weight_neighborhood;
  const double scale = config.max_dist_to_plane_ct_icp * config.min_number_neighbors;
  return (config.weight_alpha * std::pow(planarity, config.power_planarity) +
          config.weight_neighborhood * std::exp(-distance / scale)) /
         sum;
}

std::optional<CtIcpResidual> match_ct_icp(const CtIcpPoint& keypoint, const Eigen::Vector3d& placed,
                                          const VoxelNeighbours& neighbours,
                                          const CtIcpParameters& config) {
  std::vector<VoxelNeighbours::Neighbour> found;
  found.reserve(static_cast<std::size_t>(config.max_num_neighbors));
  neighbours.find(placed, found);
  if (found.size() < static_cast<std::size_t>(config.min_number_neighbors)) return std::nullopt;
  const CtIcpPlane plane = fit_ct_icp_plane(found);
  // The original means the nearest, but empties its queue of neighbours from the far end.
  const Eigen::Vector3d& anchor =
      config.nearest_anchor ? *found.front().point : *found.back().point;
  const double weight = ct_icp_weight(plane.planarity, (anchor - placed).norm(), config);
  return CtIcpResidual{keypoint.point, keypoint.alpha, anchor, plane.normal, weight};
}

CtIcpResult register_ct_icp(const std::vector<CtIcpPoint>& keypoints,
                            const VoxelNeighbours& neighbours, const CtIcpFrame& start,
                            const CtIcpFrame& previous, const CtIcpParameters& config,
                            const Workers& workers) {
  CtIcpResult result;
  result.frame = start;
  result.keypoints = static_cast<int>(keypoints.size());
  std::vector<CtIcpResidual> residuals;
  while (result.iterations < config.num_iters_icp && !result.converged) {
    residuals = match_all(keypoints, neighbours, result.frame, config, workers);
    result.residuals = static_cast<int>(residuals.size());
    if (result.residuals < config.min_number_neighbors) return result;
    const CtIcpFrame next = solve_ct_icp(residuals, result.frame, previous, config, workers);
    if (!all_finite(next)) return result;
    result.converged = is_still(result.frame, next, config);
    result.frame = next;
    ++result.iterations;
  }
  result.success = true;
  result.equations = rigid_equations(residuals, result.frame, config, workers);
  return result;
}

double degrees_between(const Pose& a, const Pose& b) {
  return a.rotation.angularDistance(b.rotation) * 180.0 / std::numbers::pi;
}

}  // namespace surefoot
