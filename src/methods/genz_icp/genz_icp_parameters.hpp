// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// The original's, under its names.
struct GenzIcpParameters {
  double max_range, min_range;  // [m]
  double map_cleanup_radius;    // [m]
  int max_points_per_voxel;
  double voxel_size;  // [m] of the map, and thinning to begin with
  int desired_num_voxelized_points;
  double min_motion_th;      // [m]
  double initial_threshold;  // [m]
  double planarity_threshold;
  bool deskew;
  int max_num_iterations;
  double convergence_criterion;  // [m, rad]
  bool floor_voxels;             // cells of equal size also at zero
};

}  // namespace surefoot
