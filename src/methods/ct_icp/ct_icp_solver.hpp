// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/normal_equations.hpp"
#include "core/parallel.hpp"
#include "methods/ct_icp/ct_icp_parameters.hpp"
#include "surefoot/pose.hpp"

namespace surefoot {

/// The two poses of a scan, T_map_lidar at its first and at its last instant. In between, rotations
/// are interpolated on the sphere and positions along the line.
struct CtIcpFrame {
  Pose begin;
  Pose end;
};

/// A change of a frame: [x y z roll pitch yaw] of the first pose, then of the last; rotations are
/// applied from the left, about each pose's own position.
using CtIcpStep = Eigen::Matrix<double, 12, 1>;
[[nodiscard]] CtIcpFrame moved(const CtIcpFrame& frame, const CtIcpStep& step);

/// The motion between a frame's two poses, for many points.
class CtIcpMotion {
 public:
  explicit CtIcpMotion(const CtIcpFrame& frame);

  /// A point (LiDAR frame) measured at `alpha`, in the map.
  [[nodiscard]] Eigen::Vector3d place(double alpha, const Eigen::Vector3d& point) const {
    return rotate(alpha, point) + translation(alpha);
  }
  [[nodiscard]] Pose at(double alpha) const;
  /// Derivative of normal . place(alpha, point) by the frame's change.
  [[nodiscard]] Eigen::Matrix<double, 1, 12> derivative(double alpha, const Eigen::Vector3d& point,
                                                        const Eigen::Vector3d& normal) const;

 private:
  [[nodiscard]] Eigen::Vector3d rotate(double alpha, const Eigen::Vector3d& point) const;
  [[nodiscard]] Eigen::Vector3d translation(double alpha) const;

  CtIcpFrame frame_;
  Eigen::Matrix3d R_begin_;
  double angle_;                       // [rad] from the first pose to the last
  Eigen::Vector3d axis_;               // of that rotation, in the map's axes
  Eigen::Matrix3d left_inverse_;       // J_l^-1 of that rotation
  Eigen::Matrix3d left_inverse_back_;  // and of the one back
};

/// A keypoint and the plane of the map that it should lie on.
struct CtIcpResidual {
  Eigen::Vector3d point;   // LiDAR frame
  double alpha;            // when it was measured
  Eigen::Vector3d anchor;  // a point of the plane
  Eigen::Vector3d normal;  // unit
  double weight;
};

/// weight * normal . (anchor - placed) [m], and its derivative by the frame's change.
[[nodiscard]] double ct_icp_residual(const CtIcpResidual& residual, const CtIcpMotion& motion);
[[nodiscard]] Eigen::Matrix<double, 1, 12> ct_icp_jacobian(const CtIcpResidual& residual,
                                                           const CtIcpMotion& motion);

/// What the trajectory is held to, for `residuals` keypoints: begin where the scan before ended
/// (beta_location_consistency, beta_orientation_consistency), go on with its velocity
/// (beta_constant_velocity), be slow (beta_small_velocity). Equations with their cost in
/// weighted_squares.
[[nodiscard]] NormalEquations<12> ct_icp_constraints(const CtIcpFrame& frame,
                                                     const CtIcpFrame& previous, int residuals,
                                                     const CtIcpParameters& config);

/// What Ceres' trust-region minimiser gives for the keypoints under a Cauchy loss of
/// ct_icp.ls_sigma and the trajectory's constraints, after at most ct_icp.ls_max_num_iters steps.
[[nodiscard]] CtIcpFrame solve_ct_icp(const std::vector<CtIcpResidual>& residuals,
                                      const CtIcpFrame& start, const CtIcpFrame& previous,
                                      const CtIcpParameters& config, const Workers& workers);

/// The keypoints' equations for a twist about the map's origin that moves the whole scan.
[[nodiscard]] NormalEquations<6> rigid_equations(const std::vector<CtIcpResidual>& residuals,
                                                 const CtIcpFrame& frame,
                                                 const CtIcpParameters& config,
                                                 const Workers& workers);

}  // namespace surefoot
