// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/method.hpp"
#include "methods/genz_icp/genz_icp_front_end.hpp"
#include "methods/genz_icp/genz_icp_parameters.hpp"
#include "methods/registry.hpp"
#include "methods/shared/baseline_config.hpp"

namespace surefoot {

namespace {

#define SLOT(member) \
  [](Config& c) { return field_slot(own_parameters<GenzIcpParameters>(c).member); }

constexpr const char* kGenz = "GenZ-ICP 0.3.2+16, odometry.launch";

const ConfigField kFields[] = {
    {"genz_icp.max_range", SLOT(max_range), "100", "m", 1.0, 1000.0, "farther points are left out",
     kGenz},
    {"genz_icp.min_range", SLOT(min_range), "0.3", "m", 0.0, 100.0, "nearer points are left out",
     kGenz},
    {"genz_icp.map_cleanup_radius", SLOT(map_cleanup_radius), "100", "m", 1.0, 10000.0,
     "cells farther from the sensor leave the map", kGenz},
    {"genz_icp.max_points_per_voxel", SLOT(max_points_per_voxel), "1", "", 1, 64,
     "a full cell takes no more points", kGenz},
    {"genz_icp.voxel_size", SLOT(voxel_size), "0.3", "m", 0.02, 10.0,
     "cell of the map, and of the thinning that is adapted from then on", kGenz},
    {"genz_icp.desired_num_voxelized_points", SLOT(desired_num_voxelized_points), "2000", "", 1,
     1e6, "the thinning is adapted towards this number of registered points", kGenz},
    {"genz_icp.min_motion_th", SLOT(min_motion_th), "0.1", "m", 0.0, 10.0,
     "smaller deviations from the prediction do not change the threshold", kGenz},
    {"genz_icp.initial_threshold", SLOT(initial_threshold), "2", "m", 1e-3, 100.0,
     "adaptive threshold while the sensor is near its start", kGenz},
    {"genz_icp.planarity_threshold", SLOT(planarity_threshold), "0.2", "", 0.0, 1.0,
     "neighbourhoods with a smaller share of variance along the normal are planar", kGenz},
    {"genz_icp.deskew", SLOT(deskew), "false", "", 0, 0,
     "points are brought to mid-scan by the last motion", kGenz},
    {"genz_icp.max_num_iterations", SLOT(max_num_iterations), "100", "", 1, 10000,
     "iterations at most", kGenz},
    {"genz_icp.convergence_criterion", SLOT(convergence_criterion), "0.0001", "m, rad", 0.0, 1.0,
     "stop when an update's norm is below this", kGenz},
    {"genz_icp.floor_voxels", SLOT(floor_voxels), "false", "", 0, 0,
     "round cells down; the original rounds towards zero, where cells are twice as wide", kGenz},
};

#undef SLOT

/// One of GenZ-ICP's configuration files; what they all share are the defaults.
Config genz_icp(double max_range, double min_range, double voxel_size, int desired_points,
                double planarity_threshold, int max_points_per_voxel,
                double map_cleanup_radius = 100.0) {
  Config config = baseline_config("genz-icp");
  GenzIcpParameters& genz = own_parameters<GenzIcpParameters>(config);
  genz.max_range = max_range;
  genz.min_range = min_range;
  genz.voxel_size = voxel_size;
  genz.desired_num_voxelized_points = desired_points;
  genz.planarity_threshold = planarity_threshold;
  genz.max_points_per_voxel = max_points_per_voxel;
  genz.map_cleanup_radius = map_cleanup_radius;
  return config;
}

std::vector<Preset> presets() {
  return {
      {"genz-icp", baseline_config("genz-icp")},
      {"genz-icp-corridor", genz_icp(100.0, 0.5, 0.2, 2000, 0.2, 1)},
      {"genz-icp-exp07", genz_icp(120.0, 0.5, 0.2, 2000, 0.2, 1)},
      {"genz-icp-indoor", genz_icp(100.0, 0.3, 0.3, 2000, 0.2, 1)},
      {"genz-icp-kitti", genz_icp(100.0, 5.0, 0.6, 3000, 0.18, 3)},
      {"genz-icp-long-corridor", genz_icp(100.0, 0.5, 0.25, 2000, 0.2, 1, 300.0)},
      {"genz-icp-newer-college", genz_icp(120.0, 0.5, 0.6, 3000, 0.2, 3)},
      {"genz-icp-outdoor", genz_icp(100.0, 0.5, 0.6, 3000, 0.2, 3)},
  };
}

}  // namespace

const Method& genz_icp_method() {
  static const Method method = {
      .name = "genz-icp",
      .fields = kFields,
      .make_parameters = [] { return std::any(GenzIcpParameters{}); },
      .presets = presets,
      .make_front_end = make_front_end<GenzIcpFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
