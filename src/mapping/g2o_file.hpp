// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Pose graphs as the field keeps them: lines VERTEX_SE3:QUAT and EDGE_SE3:QUAT (g2o), EDGE3 (iSAM:
// roll pitch yaw). Information is of the rotation vector [rad], translation first, as GTSAM and
// Ceres' example read it; iSAM's lines hold its upper triangular root.
#pragma once

#include <string>
#include <string_view>

#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

/// Edges from one pose to the next are inliers. Poses without a vertex stand at the origin. Throws
/// std::invalid_argument naming the line.
[[nodiscard]] PoseGraph parse_g2o(std::string_view text);
/// Every number as many digits as it takes to read back the same.
[[nodiscard]] std::string format_g2o(const PoseGraph& graph);

}  // namespace surefoot::mapping
