// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The parameters of the odometry: here what methods share and what the default one reads; those of
// the methods to compare with are reached by name. Defaults, units, ranges and where each value
// comes from stand once, in the table behind parameters(); `surefoot config` and docs/config.md
// print it.
#pragma once

#include <any>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// Where the level frame, in which "horizontal" and "vertical" are split, comes from.
enum class LevelMode {
  ground,  ///< the ground seen in the first scan
  mount,   ///< the mount given by the user: the base is level at the start
  none     ///< the LiDAR's own z axis
};

/// Parameters of the odometry; constant once an Odometry was made from them.
struct Config {
  /// Which front-end registers the scans: surefoot, paper, kiss-icp, icp, genz-icp, floam or
  /// ct-icp. Each reads parameters of its own: reads_parameter(). See method_config().
  std::string method = "surefoot";

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

  struct Map {
    double radius;  // [m] of methods surefoot and paper: what is farther from the sensor leaves
  } map;

  struct Health {
    int min_matches;
    double min_match_ratio;  // of the registered points, at the end
    double max_correction;   // [m] registration against prediction
    double max_correction_deg;
    double min_information;  // share of the average below which a direction is degenerate
    int restart_after;       // scans lost in a row before it is searched, or the map begun anew
  } health;

  /// Method surefoot.
  struct Knots {
    int segments;             // K: of a scan
    int points;               // to be registered
    int map_points;           // of a scan that enter the map
    double map_voxel;         // [m] they are thinned to no finer cubes
    double finest_voxel;      // [m] of the map's finest grid
    int levels;               // grids, each twice as coarse as the last
    int divided_at;           // points of a voxel that the finest grid divides; 0: it takes all
    int points_per_voxel;     // a full voxel takes no more
    int min_points;           // that a surfel needs
    double breadth;           // least standard deviation of a surfel's points, in voxels
    double flatness;          // largest variance across a plane, of that along it
    double slenderness;       // largest variance across a pole, of that along it
    double edge_on;           // least angle (sine) at which a plane's points were seen
    double ring_gap;          // [rad] between a LiDAR's rings: a cloud is known no finer
    double cloud_weight;      // of a cloud's residuals, those of planes and poles being 1
    int gone_after;           // scans that beams went through a voxel until it is emptied, 0: never
    double noise;             // [m] of a residual
    double independence;      // share of the residuals that count as independent
    double correlation_time;  // [s] of the velocity's fluctuation
    double learning_rate;     // of the velocity's fluctuation, per scan
    double mean_rate;         // of its mean, per scan
    double memory;            // share of the last knots' information that the next scan keeps
    double kernel_start;      // [m] robust kernel of the first iteration
    double kernel_end;        // [m] and at the end
    double kernel_decay;      // per iteration
    int max_iterations;
    double convergence;       // [m, rad]
    bool second_attempt;      // where the misfit is worse than usual
    double suspicious;        // by so many times
    double misfit_margin;     // beyond twice the usual and this, it is tried more loosely
    double usual_rate;        // of usual misfit and dependence, per scan
    double unseen_weight;     // of a point where the map has no surfel, among attempts
    double swing;             // [rad/s] attempts that roll and pitch by so much more
    double turn;              // [rad/s] attempts that turn by so much more
    double swing_kernel;      // [m] of these
    double looser;            // of attempts that turn and of the last ones, times the usual
    double gone_share;        // of the scans that ever hit a voxel, besides gone_after
    double lost_probability;  // of a wrong pose, beyond which it is lost; 1: never
    int search_scans;         // that it searches for itself until a new segment begins
  } knots;

  /// What the other methods read, each in a struct of its own: reached by name alone, with
  /// set_parameter() and get_parameter(). Copied with the rest.
  std::vector<std::any> others;

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

/// The parameter table.
[[nodiscard]] const std::vector<ParameterInfo>& parameters();
/// Sets one parameter from text. Throws ConfigError.
void set_parameter(Config& config, std::string_view name, std::string_view value);
/// A parameter as text that set_parameter takes back to the same value.
[[nodiscard]] std::string get_parameter(const Config& config, std::string_view name);
/// Whether config.method reads a parameter; one that it does not read changes nothing. Throws
/// ConfigError if there is no such method.
[[nodiscard]] bool reads_parameter(const Config& config, std::string_view name);
/// Throws ConfigError if there is no such method, a value is out of its range, or two values that
/// the method reads contradict each other.
void validate(const Config& config);

/// T_base_lidar of the parameters level.mount_*.
[[nodiscard]] Pose mount_pose(const Config::Level& level);

/// Names of the methods and of their variants: named sets of parameters.
[[nodiscard]] const std::vector<std::string>& methods();
/// Parameters of a method. Throws ConfigError naming the methods there are.
[[nodiscard]] Config method_config(std::string_view method);

}  // namespace surefoot
