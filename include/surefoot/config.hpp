// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Every parameter of the odometry. Defaults, units, ranges and where each value comes from stand
// once, in the table behind parameters(); `surefoot config` and docs/config.md print it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "surefoot/pose.hpp"

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

/// Which front-end registers the scans; each reads its own parameters. See method_config().
enum class Method {
  surefoot,  ///< poses within the scan estimated by registration, docs/method.md
  paper,     ///< the paper's Algorithm 1 and its variants
  kiss_icp,  ///< KISS-ICP; these are the systems to compare with, see docs/baselines.md
  icp,       ///< classical point-to-point ICP
  genz_icp,  ///< GenZ-ICP
  floam,     ///< F-LOAM
  ct_icp     ///< CT-ICP
};

/// What the classical ICP aligns a scan with.
enum class IcpTarget {
  scan,  ///< the scan before
  map    ///< all scans before, thinned in a voxel map
};

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

/// What of the map a source point is matched with: q_i.
enum class TargetKind {
  point,   ///< the nearest map point
  surface  ///< the nearest place on the surface about that point, where the map is flat there
};

/// A registration's residual: eq. (13) or eq. (23).
enum class Residual { point_to_point, point_to_plane };

/// Where the level frame, in which "horizontal" and "vertical" are split, comes from.
enum class LevelMode {
  ground,  ///< the ground seen in the first scan
  mount,   ///< the mount given by the user: the base is level at the start
  none     ///< the LiDAR's own z axis
};

/// Parameters of the odometry; constant once an Odometry was made from them.
struct Config {
  Method method = Method::surefoot;

  struct Preprocess {
    double min_range;   // [m]
    double max_range;   // [m]
    int min_points;     // fewer valid points: scan rejected
    double min_extent;  // [m] smaller cloud: scan rejected
  } preprocess;

  struct Level {
    LevelMode mode;
    double max_tilt_deg;  // a plane steeper than this in the LiDAR frame is not the ground
    double mount_x, mount_y, mount_z;                       // T_base_lidar [m]
    double mount_roll_deg, mount_pitch_deg, mount_yaw_deg;  // T_base_lidar
  } level;

  struct MotionPrior {
    double max_extrapolation;  // [s] longer gaps are predicted for this long only
  } motion_prior;

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
    double radius;       // [m] voxels farther from the sensor leave
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

  struct Health {
    int min_matches;
    double min_match_ratio;  // of the registered points, at the end
    double max_correction;   // [m] registration against prediction
    double max_correction_deg;
    double min_information;  // share of the average below which a direction is degenerate
    int restart_after;       // scans lost in a row before the map is begun anew
  } health;

  /// Method::surefoot.
  struct Knots {
    int segments;             // K: of a scan
    int points;               // to be registered
    int map_points;           // of a scan that enter the map
    double map_voxel;         // [m] they are thinned to no finer cubes
    double finest_voxel;      // [m] of the map's finest grid
    int levels;               // grids, each twice as coarse as the last
    int points_per_voxel;     // a full voxel takes no more
    int min_points;           // that a surfel needs
    double breadth;           // least standard deviation of a surfel's points, in voxels
    double flatness;          // largest variance across a plane, of that along it
    double slenderness;       // largest variance across a pole, of that along it
    double edge_on;           // least angle (sine) at which a plane's points were seen
    double ring_gap;          // [rad] between a LiDAR's rings: a cloud is known no finer
    double cloud_weight;      // of a cloud's residuals, those of planes and poles being 1
    int gone_after;           // scans that beams went through a voxel until it is emptied, 0: never
    double min_match_ratio;   // of the registered points
    double noise;             // [m] of a residual
    double independence;      // share of the residuals that count as independent
    double correlation_time;  // [s] of the velocity's fluctuation
    double learning_rate;     // of mean velocity and fluctuation, per scan
    double memory;            // share of the last knots' information that the next scan keeps
    double kernel_start;      // [m] robust kernel of the first iteration
    double kernel_end;        // [m] and at the end
    double kernel_decay;      // per iteration
    int max_iterations;
    double convergence;       // [m, rad]
    bool second_attempt;      // where the misfit is worse than usual
    double suspicious;        // by so many times
    double misfit_margin;     // beyond twice the usual and this, a registration is wrong
    double usual_rate;        // of usual misfit and dependence, per scan
    double unseen_weight;     // of a point where the map has no surfel, among attempts
    double swing;             // [rad/s] attempts that roll and pitch by so much more
    double swing_kernel;      // [m] of these
    double looser;            // of the last attempts, times the usual fluctuation
    double gone_share;        // of the scans that ever hit a voxel, besides gone_after
    double lost_probability;  // of a wrong pose, beyond which it is lost; 1: never
    int search_scans;         // that it searches for itself until a new segment begins
    double covariance_scale;  // variance beyond the residuals'
  } knots;

  // The baselines' parameters, under their originals' names.

  struct KissIcp {
    double max_range, min_range;  // [m] of the deskewed points
    bool deskew;
    double voxel_size;  // [m] of the map; half of it thins what enters, 1.5 of it what is matched
    int max_points_per_voxel;
    double initial_threshold;  // [m] of the adaptive threshold
    double min_motion_th;      // [m] smaller deviations from the prediction do not count
    int max_num_iterations;
    double convergence_criterion;  // [m, rad]
  } kiss_icp;

  struct Icp {
    IcpTarget target;
    bool constant_velocity;              // begins where the last motion leads
    double max_correspondence_distance;  // [m]
    int max_iteration;
    double relative_fitness;
    double relative_rmse;
    double voxel_size;  // [m] of the map
    int max_points_per_voxel;
  } icp;

  struct GenzIcp {
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
  } genz_icp;

  struct Floam {
    int scan_line;            // lasers
    double max_dis, min_dis;  // [m] horizontal distance
    double map_resolution;    // [m] thinning of edges; of surfaces twice that
    bool use_rings;           // lines from the scan's ring numbers
    bool whole_sectors;
    bool centred_planes;
    bool distortion_compensation;  // the paper's two steps
  } floam;

  struct CtIcp {
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
  } ct_icp;

  /// The defaults of the parameter table.
  Config();
};

/// A value out of range or an unknown name; the message names key, value, unit and range.
class ConfigError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// One row of the parameter table.
struct ParameterInfo {
  std::string name;  ///< "deskew.segments"
  std::string default_value;
  std::string unit;    ///< "" where the value has none
  std::string range;   ///< "1 .. 64" or "none | constant_velocity | piecewise"
  std::string help;    ///< one line; the paper's symbol where it has one
  std::string source;  ///< where the default comes from
};

/// The parameter table, in the order of Config.
[[nodiscard]] const std::vector<ParameterInfo>& parameters();
/// Sets one parameter from text. Throws ConfigError.
void set_parameter(Config& config, std::string_view name, std::string_view value);
/// A parameter as text that set_parameter takes back to the same value.
[[nodiscard]] std::string get_parameter(const Config& config, std::string_view name);
/// Throws ConfigError if a value is out of its range or two values contradict each other.
void validate(const Config& config);

/// T_base_lidar of the parameters level.mount_*.
[[nodiscard]] Pose mount_pose(const Config::Level& level);

/// Names of the methods: named sets of parameters.
[[nodiscard]] const std::vector<std::string>& methods();
/// Parameters of a method. Throws ConfigError naming the methods there are.
[[nodiscard]] Config method_config(std::string_view method);

}  // namespace surefoot
