// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The named sets of parameters. docs/baselines.md says where the baselines' come from.
#include <utility>

#include "surefoot/config.hpp"

namespace surefoot {

namespace {

Config paper() {
  Config config;
  config.method = Method::paper;
  return config;
}

Config with_deskew(DeskewMode mode) {
  Config config = paper();
  config.deskew.mode = mode;
  return config;
}

/// A departure from the paper that follows smooth walks: docs/equations.md.
Config on_surface() {
  Config config = paper();
  config.registration.target = TargetKind::surface;
  return config;
}

Config coupled() {
  Config config = paper();
  config.registration.mode = RegistrationMode::coupled;
  return config;
}

/// A baseline limits ranges itself, and begins its map with the LiDAR's own axes.
Config baseline(Method method) {
  Config config;
  config.method = method;
  config.preprocess.min_range = 0.0;
  config.preprocess.max_range = 1000.0;
  config.level.mode = LevelMode::none;
  return config;
}

/// ICP has no range limits of its own; near points are the robot's body for it too.
Config icp() {
  Config config = baseline(Method::icp);
  config.preprocess = Config().preprocess;
  return config;
}

/// One of GenZ-ICP's configuration files; what they all share are the defaults.
Config genz_icp(double max_range, double min_range, double voxel_size, int desired_points,
                double planarity_threshold, int max_points_per_voxel,
                double map_cleanup_radius = 100.0) {
  Config config = baseline(Method::genz_icp);
  config.genz_icp.max_range = max_range;
  config.genz_icp.min_range = min_range;
  config.genz_icp.voxel_size = voxel_size;
  config.genz_icp.desired_num_voxelized_points = desired_points;
  config.genz_icp.planarity_threshold = planarity_threshold;
  config.genz_icp.max_points_per_voxel = max_points_per_voxel;
  config.genz_icp.map_cleanup_radius = map_cleanup_radius;
  return config;
}

/// CT-ICP's RobustDrivingProfile.
Config ct_icp_robust_driving() {
  Config config = baseline(Method::ct_icp);
  config.ct_icp.init_num_frames = 40;
  config.ct_icp.max_distance = 200.0;
  config.ct_icp.num_iters_icp = 15;
  config.ct_icp.max_dist_to_plane_ct_icp = 0.5;
  config.ct_icp.threshold_orientation_norm = 0.01;
  config.ct_icp.ls_max_num_iters = 20;
  config.ct_icp.ls_sigma = 0.2;
  config.ct_icp.robust_registration = true;
  config.ct_icp.robust_num_attempts = 10;
  config.ct_icp.robust_threshold_ego_orientation = 5.0;
  config.ct_icp.robust_threshold_relative_orientation = 5.0;
  return config;
}

/// CT-ICP's DefaultRobustOutdoorLowInertia.
Config ct_icp_low_inertia() {
  Config config = ct_icp_robust_driving();
  config.ct_icp.initialization = CtIcpInitialization::none;
  config.ct_icp.init_num_frames = 20;
  config.ct_icp.voxel_size = 0.3;
  config.ct_icp.num_iters_icp = 30;
  config.ct_icp.max_num_residuals = 600;
  config.ct_icp.weight_alpha = 0.8;
  config.ct_icp.weight_neighborhood = 0.2;
  config.ct_icp.ls_max_num_iters = 10;
  config.ct_icp.beta_location_consistency = 0.0;
  config.ct_icp.beta_constant_velocity = 0.0;
  config.ct_icp.beta_small_velocity = 0.001;
  config.ct_icp.robust_num_attempts = 3;
  config.ct_icp.robust_threshold_ego_orientation = 2.0;
  config.ct_icp.robust_threshold_relative_orientation = 2.0;
  return config;
}

/// What most of CT-ICP's files say; every one limits residuals or keypoints in its own way.
Config ct_icp_file(double min_distance_between_points, int solver_steps) {
  Config config = baseline(Method::ct_icp);
  config.ct_icp.resolution = 0.8;
  config.ct_icp.min_distance_between_points = min_distance_between_points;
  config.ct_icp.max_num_points = 30;
  config.ct_icp.default_radius = 0.75;
  config.ct_icp.ls_max_num_iters = solver_steps;
  return config;
}

/// The thresholds of the files that do not keep the default ones.
void stop_early(Config& config) {
  config.ct_icp.threshold_orientation_norm = 0.1;
  config.ct_icp.threshold_translation_norm = 0.01;
}

/// config/odometry/driving_config.yaml
Config ct_icp_driving() {
  Config config = ct_icp_file(0.1, 5);
  config.ct_icp.max_num_residuals = 900;
  stop_early(config);
  return config;
}

/// config/odometry/nclt_config.yaml
Config ct_icp_nclt() {
  Config config = baseline(Method::ct_icp);
  config.ct_icp.sampling = CtIcpSampling::adaptive;
  config.ct_icp.max_num_keypoints = 1500;
  config.ct_icp.max_num_residuals = 1500;
  config.ct_icp.min_distance_between_points = 0.05;
  config.ct_icp.max_num_points = 30;
  config.ct_icp.min_number_neighbors = 10;
  config.ct_icp.num_iters_icp = 20;
  config.ct_icp.ls_max_num_iters = 10;
  stop_early(config);
  return config;
}

/// ct_icp_driving.yaml and ct_icp_driving_fast.yaml of the ROS package.
Config ct_icp_ros_driving(int max_num_keypoints) {
  Config config = ct_icp_file(0.08, 5);
  config.ct_icp.max_num_keypoints = max_num_keypoints;
  return config;
}

/// ct_icp_subt_config.yaml of the ROS package.
Config ct_icp_subt() {
  Config config = ct_icp_file(0.08, 20);
  config.ct_icp.sampling = CtIcpSampling::adaptive;
  config.ct_icp.voxel_size = 0.3;
  config.ct_icp.min_number_neighbors = 10;
  config.ct_icp.num_iters_icp = 8;
  stop_early(config);
  return config;
}

/// nhcd_config.yaml of the ROS package: the handheld Newer College recordings.
Config ct_icp_nhcd() {
  Config config = ct_icp_subt();
  config.ct_icp.initialization = CtIcpInitialization::none;
  config.ct_icp.max_num_keypoints = 800;
  config.ct_icp.min_number_neighbors = 20;
  return config;
}

using NamedConfig = std::pair<std::string, Config>;

const std::vector<NamedConfig>& named_configs() {
  static const std::vector<NamedConfig> configs = {
      {"surefoot", Config()},
      {"paper", paper()},
      {"paper-cv", with_deskew(DeskewMode::constant_velocity)},
      {"paper-no-deskew", with_deskew(DeskewMode::none)},
      {"paper-coupled", coupled()},
      {"paper-surface", on_surface()},
      {"kiss-icp", baseline(Method::kiss_icp)},
      {"icp", icp()},
      {"genz-icp", baseline(Method::genz_icp)},
      {"genz-icp-corridor", genz_icp(100.0, 0.5, 0.2, 2000, 0.2, 1)},
      {"genz-icp-exp07", genz_icp(120.0, 0.5, 0.2, 2000, 0.2, 1)},
      {"genz-icp-indoor", genz_icp(100.0, 0.3, 0.3, 2000, 0.2, 1)},
      {"genz-icp-kitti", genz_icp(100.0, 5.0, 0.6, 3000, 0.18, 3)},
      {"genz-icp-long-corridor", genz_icp(100.0, 0.5, 0.25, 2000, 0.2, 1, 300.0)},
      {"genz-icp-newer-college", genz_icp(120.0, 0.5, 0.6, 3000, 0.2, 3)},
      {"genz-icp-outdoor", genz_icp(100.0, 0.5, 0.6, 3000, 0.2, 3)},
      {"floam", baseline(Method::floam)},
      {"ct-icp", baseline(Method::ct_icp)},
      {"ct-icp-robust-driving", ct_icp_robust_driving()},
      {"ct-icp-low-inertia", ct_icp_low_inertia()},
      {"ct-icp-driving", ct_icp_driving()},
      {"ct-icp-nclt", ct_icp_nclt()},
      {"ct-icp-ros-driving", ct_icp_ros_driving(-1)},
      {"ct-icp-ros-driving-fast", ct_icp_ros_driving(800)},
      {"ct-icp-nhcd", ct_icp_nhcd()},
      {"ct-icp-subt", ct_icp_subt()},
  };
  return configs;
}

}  // namespace

const std::vector<std::string>& methods() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const NamedConfig& named : named_configs()) result.push_back(named.first);
    return result;
  }();
  return names;
}

Config method_config(std::string_view method) {
  for (const auto& [name, config] : named_configs()) {
    if (name == method) return config;
  }
  std::string known;
  for (const std::string& name : methods()) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError("there is no method '" + std::string(method) + "'; there are: " + known);
}

}  // namespace surefoot
