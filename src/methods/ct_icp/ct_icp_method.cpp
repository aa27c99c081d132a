// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/ct_icp/ct_icp_front_end.hpp"
#include "methods/ct_icp/ct_icp_parameters.hpp"
#include "methods/registry.hpp"
#include "methods/shared/baseline_config.hpp"

namespace surefoot {

namespace {

constexpr const char* kInitializations[] = {"none", "constant_velocity"};
constexpr const char* kSamplings[] = {"none", "grid", "adaptive"};

#define SLOT(member) [](Config& c) { return field_slot(own_parameters<CtIcpParameters>(c).member); }
#define WORDS(member, words) \
  [](Config& c) { return field_slot(own_parameters<CtIcpParameters>(c).member, words); }

constexpr const char* kCtIcp = "CT-ICP d467813, DefaultDrivingProfile";

const ConfigField kFields[] = {
    {"ct_icp.initialization", WORDS(initialization, kInitializations), "constant_velocity", "", 0,
     0, "where the solver begins: as the scan before moved, or where it ended", kCtIcp},
    {"ct_icp.sampling", WORDS(sampling, kSamplings), "grid", "", 0, 0,
     "which thinned points are registered", kCtIcp},
    {"ct_icp.init_num_frames", SLOT(init_num_frames), "20", "", 0, 1e6,
     "scans that start the map: finer thinning, at least 15 iterations", kCtIcp},
    {"ct_icp.init_voxel_size", SLOT(init_voxel_size), "0.2", "m", 0.02, 10.0, "thinning of these",
     kCtIcp},
    {"ct_icp.init_sample_voxel_size", SLOT(init_sample_voxel_size), "1", "m", 0.02, 10.0,
     "cells of the registered points of these", kCtIcp},
    {"ct_icp.voxel_size", SLOT(voxel_size), "0.5", "m", 0.02, 10.0,
     "thinning: one point of every cell", kCtIcp},
    {"ct_icp.sample_voxel_size", SLOT(sample_voxel_size), "1.5", "m", 0.02, 10.0,
     "cells of the registered points, for ct_icp.sampling grid", kCtIcp},
    {"ct_icp.max_num_keypoints", SLOT(max_num_keypoints), "-1", "", -1, 1e6,
     "registered points, a choice by chance; -1: all", kCtIcp},
    {"ct_icp.max_distance", SLOT(max_distance), "100", "m", 1.0, 10000.0,
     "cells farther from the sensor are dropped", kCtIcp},
    {"ct_icp.resolution", SLOT(resolution), "0.5", "m", 0.05, 10.0,
     "cell size of the map that is searched", kCtIcp},
    {"ct_icp.min_distance_between_points", SLOT(min_distance_between_points), "0.1", "m", 0.0, 10.0,
     "between the points of one cell", kCtIcp},
    {"ct_icp.max_num_points", SLOT(max_num_points), "40", "", 1, 200,
     "points in one cell of the map", kCtIcp},
    {"ct_icp.default_radius", SLOT(default_radius), "0.8", "m", 0.05, 80.0,
     "neighbours are not farther", kCtIcp},
    {"ct_icp.max_num_neighbors", SLOT(max_num_neighbors), "20", "", 3, 200,
     "neighbours of a plane, at most", kCtIcp},
    {"ct_icp.min_number_neighbors", SLOT(min_number_neighbors), "20", "", 3, 200,
     "neighbours of a plane, at least; and residuals of a scan", kCtIcp},
    {"ct_icp.num_iters_icp", SLOT(num_iters_icp), "5", "", 1, 1000, "iterations, at most", kCtIcp},
    {"ct_icp.max_num_residuals", SLOT(max_num_residuals), "-1", "", -1, 1e6,
     "residuals of a scan, at most; -1: all", kCtIcp},
    {"ct_icp.weight_alpha", SLOT(weight_alpha), "0.9", "", 1e-06, 1e6,
     "share of planarity in a residual's weight", kCtIcp},
    {"ct_icp.weight_neighborhood", SLOT(weight_neighborhood), "0.1", "", 0.0, 1e6,
     "share of the distance to the plane's point", kCtIcp},
    {"ct_icp.power_planarity", SLOT(power_planarity), "2", "", 0.0, 100.0,
     "of planarity in the weight", kCtIcp},
    {"ct_icp.max_dist_to_plane_ct_icp", SLOT(max_dist_to_plane_ct_icp), "0.3", "m", 0.001, 100.0,
     "times ct_icp.min_number_neighbors: scale of that distance", kCtIcp},
    {"ct_icp.threshold_orientation_norm", SLOT(threshold_orientation_norm), "0.0001", "deg", 0.0,
     10.0, "converged if both poses turned less,", kCtIcp},
    {"ct_icp.threshold_translation_norm", SLOT(threshold_translation_norm), "0.001", "m", 0.0, 10.0,
     "and moved less", kCtIcp},
    {"ct_icp.ls_max_num_iters", SLOT(ls_max_num_iters), "1", "", 1, 1000,
     "steps of the solver in one iteration", kCtIcp},
    {"ct_icp.ls_sigma", SLOT(ls_sigma), "0.1", "m", 1e-06, 100.0, "scale of the Cauchy loss",
     kCtIcp},
    {"ct_icp.beta_location_consistency", SLOT(beta_location_consistency), "0.001", "", 0.0, 1e6,
     "weight of beginning where the scan before ended", kCtIcp},
    {"ct_icp.beta_constant_velocity", SLOT(beta_constant_velocity), "0.001", "", 0.0, 1e6,
     "weight of moving as the scan before", kCtIcp},
    {"ct_icp.beta_small_velocity", SLOT(beta_small_velocity), "0", "", 0.0, 1e6,
     "weight of not moving within the scan", kCtIcp},
    {"ct_icp.beta_orientation_consistency", SLOT(beta_orientation_consistency), "0", "", 0.0, 1e6,
     "weight of beginning turned as the scan before ended", kCtIcp},
    {"ct_icp.distance_error_threshold", SLOT(distance_error_threshold), "5", "m", 0.0, 1000.0,
     "a longer way within a scan is an error", kCtIcp},
    {"ct_icp.orientation_error_threshold", SLOT(orientation_error_threshold), "30", "deg", 0.0,
     180.0, "a greater turn within a scan, or since the last, is an error", kCtIcp},
    {"ct_icp.insertion_ego_rotation_threshold", SLOT(insertion_ego_rotation_threshold), "3", "deg",
     0.0, 180.0, "scans that turn more do not enter the map", kCtIcp},
    {"ct_icp.insertion_threshold_frames_skipped", SLOT(insertion_threshold_frames_skipped), "5", "",
     0, 1e6, "unless more than so many in a row have not", kCtIcp},
    {"ct_icp.robust_registration", SLOT(robust_registration), "false", "", 0, 0,
     "judge registrations, try again with more effort, keep what turns fast out of the map",
     kCtIcp},
    {"ct_icp.robust_num_attempts", SLOT(robust_num_attempts), "6", "", 1, 1000,
     "attempts at a scan, at most", kCtIcp},
    {"ct_icp.robust_relative_trans_threshold", SLOT(robust_relative_trans_threshold), "1", "m", 0.0,
     1000.0, "a longer way within a scan asks for another attempt", kCtIcp},
    {"ct_icp.robust_threshold_ego_orientation", SLOT(robust_threshold_ego_orientation), "3", "deg",
     0.0, 180.0, "so does a greater turn within a scan,", kCtIcp},
    {"ct_icp.robust_threshold_relative_orientation", SLOT(robust_threshold_relative_orientation),
     "3", "deg", 0.0, 180.0, "or since the last scan's end", kCtIcp},
    {"ct_icp.floor_voxels", SLOT(floor_voxels), "false", "", 0, 0,
     "round cells down; the original rounds towards zero, where cells are twice as wide", kCtIcp},
    {"ct_icp.nearest_anchor", SLOT(nearest_anchor), "false", "", 0, 0,
     "put planes through the nearest neighbour; the original takes the farthest for the nearest",
     kCtIcp},
    {"ct_icp.robust_bookkeeping", SLOT(robust_bookkeeping), "false", "", 0, 0,
     "count the levels of effort and the failures that the original means to count", kCtIcp},
};

#undef WORDS
#undef SLOT

// A search looks at the cube of voxels within its radius; this bounds their number.
constexpr double kMaxSearchVoxels = 8.0;

void check(const Config& config) {
  const CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  if (ct.default_radius > kMaxSearchVoxels * ct.resolution) {
    throw ConfigError("ct_icp.default_radius (" + number_text(ct.default_radius) +
                      " m) must not be more than " + number_text(kMaxSearchVoxels) +
                      " times ct_icp.resolution (" + number_text(ct.resolution) + " m)");
  }
  if (ct.min_number_neighbors > ct.max_num_neighbors) {
    throw ConfigError("ct_icp.min_number_neighbors (" + number_text(ct.min_number_neighbors) +
                      ") must not be more than ct_icp.max_num_neighbors (" +
                      number_text(ct.max_num_neighbors) + ")");
  }
}

/// CT-ICP's RobustDrivingProfile.
Config robust_driving() {
  Config config = baseline_config("ct-icp");
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.init_num_frames = 40;
  ct.max_distance = 200.0;
  ct.num_iters_icp = 15;
  ct.max_dist_to_plane_ct_icp = 0.5;
  ct.threshold_orientation_norm = 0.01;
  ct.ls_max_num_iters = 20;
  ct.ls_sigma = 0.2;
  ct.robust_registration = true;
  ct.robust_num_attempts = 10;
  ct.robust_threshold_ego_orientation = 5.0;
  ct.robust_threshold_relative_orientation = 5.0;
  return config;
}

/// CT-ICP's DefaultRobustOutdoorLowInertia.
Config low_inertia() {
  Config config = robust_driving();
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.initialization = CtIcpInitialization::none;
  ct.init_num_frames = 20;
  ct.voxel_size = 0.3;
  ct.num_iters_icp = 30;
  ct.max_num_residuals = 600;
  ct.weight_alpha = 0.8;
  ct.weight_neighborhood = 0.2;
  ct.ls_max_num_iters = 10;
  ct.beta_location_consistency = 0.0;
  ct.beta_constant_velocity = 0.0;
  ct.beta_small_velocity = 0.001;
  ct.robust_num_attempts = 3;
  ct.robust_threshold_ego_orientation = 2.0;
  ct.robust_threshold_relative_orientation = 2.0;
  return config;
}

/// What most of CT-ICP's files say; every one limits residuals or keypoints in its own way.
Config of_file(double min_distance_between_points, int solver_steps) {
  Config config = baseline_config("ct-icp");
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.resolution = 0.8;
  ct.min_distance_between_points = min_distance_between_points;
  ct.max_num_points = 30;
  ct.default_radius = 0.75;
  ct.ls_max_num_iters = solver_steps;
  return config;
}

/// The thresholds of the files that do not keep the default ones.
void stop_early(CtIcpParameters& ct) {
  ct.threshold_orientation_norm = 0.1;
  ct.threshold_translation_norm = 0.01;
}

/// config/odometry/driving_config.yaml
Config driving() {
  Config config = of_file(0.1, 5);
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.max_num_residuals = 900;
  stop_early(ct);
  return config;
}

/// config/odometry/nclt_config.yaml
Config nclt() {
  Config config = baseline_config("ct-icp");
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.sampling = CtIcpSampling::adaptive;
  ct.max_num_keypoints = 1500;
  ct.max_num_residuals = 1500;
  ct.min_distance_between_points = 0.05;
  ct.max_num_points = 30;
  ct.min_number_neighbors = 10;
  ct.num_iters_icp = 20;
  ct.ls_max_num_iters = 10;
  stop_early(ct);
  return config;
}

/// ct_icp_driving.yaml and ct_icp_driving_fast.yaml of the ROS package.
Config ros_driving(int max_num_keypoints) {
  Config config = of_file(0.08, 5);
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.max_num_keypoints = max_num_keypoints;
  return config;
}

/// ct_icp_subt_config.yaml of the ROS package.
Config subt() {
  Config config = of_file(0.08, 20);
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.sampling = CtIcpSampling::adaptive;
  ct.voxel_size = 0.3;
  ct.min_number_neighbors = 10;
  ct.num_iters_icp = 8;
  stop_early(ct);
  return config;
}

/// nhcd_config.yaml of the ROS package: the handheld Newer College recordings.
Config nhcd() {
  Config config = subt();
  CtIcpParameters& ct = own_parameters<CtIcpParameters>(config);
  ct.initialization = CtIcpInitialization::none;
  ct.max_num_keypoints = 800;
  ct.min_number_neighbors = 20;
  return config;
}

std::vector<Preset> presets() {
  return {
      {"ct-icp", baseline_config("ct-icp")},
      {"ct-icp-robust-driving", robust_driving()},
      {"ct-icp-low-inertia", low_inertia()},
      {"ct-icp-driving", driving()},
      {"ct-icp-nclt", nclt()},
      {"ct-icp-ros-driving", ros_driving(-1)},
      {"ct-icp-ros-driving-fast", ros_driving(800)},
      {"ct-icp-nhcd", nhcd()},
      {"ct-icp-subt", subt()},
  };
}

}  // namespace

const Method& ct_icp_method() {
  static const Method method = {
      .name = "ct-icp",
      .fields = kFields,
      .make_parameters = [] { return std::any(CtIcpParameters{}); },
      .check = check,
      .presets = presets,
      .make_front_end = make_front_end<CtIcpFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
