// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// Which of CT-ICP's thinned points are registered.
enum class CtIcpSampling {
  none,     ///< all
  grid,     ///< one of every cell
  adaptive  ///< one of every cell, cells growing with the distance from the sensor
};

/// Where CT-ICP expects a scan's poses.
enum class CtIcpInitialization {
  none,              ///< where the scan before ended
  constant_velocity  ///< as the scan before
};

/// The original's, under its names.
struct CtIcpParameters {
  CtIcpInitialization initialization;
  CtIcpSampling sampling;
  int init_num_frames;                             // scans that start the map
  double init_voxel_size, init_sample_voxel_size;  // [m] of these
  double voxel_size;                               // [m] thinning
  double sample_voxel_size;                        // [m] of what is registered
  int max_num_keypoints;                           // -1: all
  double max_distance;                             // [m] of the map
  double resolution;                               // [m] the map's cells
  double min_distance_between_points;              // [m]
  int max_num_points;                              // in a cell
  double default_radius;                           // [m] neighbours
  int max_num_neighbors, min_number_neighbors;
  int num_iters_icp;
  int max_num_residuals;  // -1: all
  double weight_alpha, weight_neighborhood;
  double power_planarity;
  double max_dist_to_plane_ct_icp;    // [m]
  double threshold_orientation_norm;  // [deg]
  double threshold_translation_norm;  // [m]
  int ls_max_num_iters;
  double ls_sigma;  // [m]
  double beta_location_consistency, beta_constant_velocity;
  double beta_small_velocity, beta_orientation_consistency;
  double distance_error_threshold;          // [m]
  double orientation_error_threshold;       // [deg]
  double insertion_ego_rotation_threshold;  // [deg]
  int insertion_threshold_frames_skipped;
  bool robust_registration;
  int robust_num_attempts;
  double robust_relative_trans_threshold;        // [m]
  double robust_threshold_ego_orientation;       // [deg]
  double robust_threshold_relative_orientation;  // [deg]
  bool floor_voxels;                             // cells of equal size also at zero
  bool nearest_anchor;                           // planes through the nearest neighbour
  bool robust_bookkeeping;
};

}  // namespace surefoot
