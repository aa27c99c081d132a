// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// What the classical ICP aligns a scan with.
enum class IcpTarget {
  scan,  ///< the scan before
  map    ///< all scans before, thinned in a voxel map
};

/// Open3D's, under its names, and what a map needs.
struct IcpParameters {
  IcpTarget target;
  bool constant_velocity;              // begins where the last motion leads
  double max_correspondence_distance;  // [m]
  int max_iteration;
  double relative_fitness;
  double relative_rmse;
  double voxel_size;  // [m] of the map
  int max_points_per_voxel;
};

}  // namespace surefoot
