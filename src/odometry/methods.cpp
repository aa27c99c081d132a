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

using NamedConfig = std::pair<std::string, Config>;

const std::vector<NamedConfig>& named_configs() {
  static const std::vector<NamedConfig> configs = {
      {"surefoot", Config()},
      {"paper", paper()},
      {"paper-cv", with_deskew(DeskewMode::constant_velocity)},
      {"paper-no-deskew", with_deskew(DeskewMode::none)},
      {"paper-coupled", coupled()},
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
