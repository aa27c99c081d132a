// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// First guesses of a graph's poses: the field's graphs come without any, a walk's has the
// odometry's.
#pragma once

#include "mapping/pose_graph.hpp"

namespace surefoot::test {

/// Along the edges from the first pose, each pose by the edge that reaches it first, inliers before
/// others. Poses that no edge reaches stay.
void follow_edges(mapping::PoseGraph& graph);
/// A better guess where rotations are far off: rotations from all inliers at once, as matrices (a
/// linear problem), then translations. Poses that no inlier reaches stay.
void guess_by_rotations(mapping::PoseGraph& graph);

}  // namespace surefoot::test
