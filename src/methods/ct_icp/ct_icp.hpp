// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "methods/ct_icp/ct_icp_sampling.hpp"
#include "methods/ct_icp/ct_icp_solver.hpp"
#include "methods/ct_icp/voxel_neighbours.hpp"

namespace surefoot {

/// What the map is like about a place.
struct CtIcpPlane {
  Eigen::Vector3d normal;
  double planarity;  ///< a2D = (sigma_2 - sigma_3) / sigma_1, of the neighbours' spreads
};
/// From the neighbours; planarity is 0 where they are all in one place.
[[nodiscard]] CtIcpPlane fit_ct_icp_plane(std::span<const VoxelNeighbours::Neighbour> neighbours);

/// weight_alpha planarity^power_planarity + weight_neighborhood exp(-distance / (20 * 0.3 m)), the
/// two weights scaled to a sum of one; `distance` [m] from the keypoint to its plane's anchor.
[[nodiscard]] double ct_icp_weight(double planarity, double distance,
                                   const CtIcpParameters& config);

/// The plane that a keypoint, placed in the map, should lie on; none without
/// ct_icp.min_number_neighbors neighbours.
[[nodiscard]] std::optional<CtIcpResidual> match_ct_icp(const CtIcpPoint& keypoint,
                                                        const Eigen::Vector3d& placed,
                                                        const VoxelNeighbours& neighbours,
                                                        const CtIcpParameters& config);

/// One registration.
struct CtIcpResult {
  CtIcpFrame frame;
  int keypoints = 0;
  int iterations = 0;  ///< finished
  int residuals = 0;   ///< in the last of them
  bool converged = false;
  bool success = false;          ///< false: too few residuals
  NormalEquations<6> equations;  ///< the last ones, for a twist about the map's origin
};

/// CT-ICP's registration: both poses of the scan, beginning with `start`. `previous`: of the scan
/// before, to which the trajectory is held.
[[nodiscard]] CtIcpResult register_ct_icp(const std::vector<CtIcpPoint>& keypoints,
                                          const VoxelNeighbours& neighbours,
                                          const CtIcpFrame& start, const CtIcpFrame& previous,
                                          const CtIcpParameters& config, const Workers& workers);

/// Angle between two rotations [deg].
[[nodiscard]] double degrees_between(const Pose& a, const Pose& b);

}  // namespace surefoot
