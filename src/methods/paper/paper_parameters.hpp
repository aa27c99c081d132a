// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// How points are brought to the mid-scan instant.
enum class DeskewMode {
  none,               ///< points are left as measured
  constant_velocity,  ///< one twist for the scan, not clamped: what KISS-ICP does
  piecewise           ///< the paper: clamped twist, K segments, eqs. (5)-(12)
};

/// How the six degrees of freedom are solved.
enum class RegistrationMode {
  decoupled,  ///< the paper: horizontal, then vertical stage, Algorithm 1
  coupled     ///< one 6-DoF problem, eq. (4), to compare with
};

/// What of the map a source point is matched with: q_i.
enum class TargetKind {
  point,   ///< the nearest map point
  surface  ///< the nearest place on the surface about that point, where the map is flat there
};

/// A registration's residual: eq. (13) or eq. (23).
enum class Residual { point_to_point, point_to_plane };

/// The paper's, and what it leaves open. The map's radius is Config::map.
struct PaperParameters {
  struct Deskew {
    DeskewMode mode;
    int segments;        // K
    double clamp_z;      // zeta_z [m]
    double clamp_roll;   // zeta_r [rad]
    double clamp_pitch;  // zeta_p [rad]
  } deskew;

  struct Downsample {
    double map_voxel;     // [m] thinning of what enters the map
    double source_voxel;  // [m] thinning of what is registered
    int min_points;       // to be registered; else both voxels are halved
  } downsample;

  struct Map {
    double voxel_size;  // [m]
    int points_per_voxel;
    double min_spacing;  // [m]
  } map;

  struct Registration {
    RegistrationMode mode;
    Residual coupled_residual;
    TargetKind target;
    int max_iterations;
    double max_distance;      // d_max [m]
    double relaxed_distance;  // d_relaxed [m]
    int early_iterations;     // T_early = {1..early_iterations}
    double convergence;       // [m, rad]
  } registration;

  struct Horizontal {
    double kernel_scale;  // kappa_H [m]
  } horizontal;

  struct Vertical {
    Residual residual;
    int sub_iterations;       // U_V
    int min_neighbours;       // N_min
    double min_normal_z;      // tau_n
    double max_range;         // r_max [m]
    double near_distance;     // d_0 [m]
    double distance_decay;    // beta [1/m^2]
    double normal_power;      // of |n_z| in eta; 0: all normals count alike
    double near_gate;         // epsilon_0 [m]
    double near_suppression;  // epsilon_s
    double kernel_scale;      // kappa_V [m]
    double trust_region;      // zeta_V [m, rad]
  } vertical;
};

}  // namespace surefoot
