// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// The original's, under its names.
struct KissIcpParameters {
  double max_range, min_range;  // [m] of the deskewed points
  bool deskew;
  double voxel_size;  // [m] of the map; half of it thins what enters, 1.5 of it what is matched
  int max_points_per_voxel;
  double initial_threshold;  // [m] of the adaptive threshold
  double min_motion_th;      // [m] smaller deviations from the prediction do not count
  int max_num_iterations;
  double convergence_criterion;  // [m, rad]
};

}  // namespace surefoot
