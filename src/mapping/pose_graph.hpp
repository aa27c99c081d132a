// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Poses, and what was measured between them.
#pragma once

#include <cstddef>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot::mapping {

/// A measured motion between two poses.
struct PoseEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose T_from_to;
  Matrix6 information = Matrix6::Identity();  ///< of edge_error(); may be singular
  bool inlier = true;  ///< known to be right (odometry); else it may be switched off
  double way = 0.0;    ///< of odometry [m]: what it gets wrong the same way all along adds up
};

struct PoseGraph {
  std::vector<Pose> poses;  ///< T_world_pose; the first one stays where it is
  std::vector<PoseEdge> edges;
  /// Of each metre of the edges' way: standard deviation of an error of the motion that is the same
  /// all along, and so does not average out as the edges' own covariances do.
  Twist systematic = Twist::Zero();
};

/// Where the measurement would have the second pose, against where it is: a twist in its frame.
[[nodiscard]] Twist edge_error(const PoseEdge& edge, const Pose& from, const Pose& to);
/// Its derivatives by small motions of the poses, each in the pose's own frame.
struct EdgeJacobians {
  Matrix6 from, to;
};
[[nodiscard]] EdgeJacobians edge_jacobians(const Twist& error, const Pose& from, const Pose& to);

/// Squared error by the edge's information: for a right edge chi-squared distributed, 6 degrees.
[[nodiscard]] double chi2(const PoseEdge& edge, const std::vector<Pose>& poses);
/// Sum over the edges.
[[nodiscard]] double chi2(const PoseGraph& graph);

/// Quantiles of chi-squared with six degrees of freedom.
inline constexpr double kChi2Of6At99 = 16.812;
inline constexpr double kChi2Of6At999 = 22.458;

}  // namespace surefoot::mapping
