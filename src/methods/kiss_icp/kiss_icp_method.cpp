// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/method.hpp"
#include "methods/kiss_icp/kiss_icp_front_end.hpp"
#include "methods/kiss_icp/kiss_icp_parameters.hpp"
#include "methods/registry.hpp"
#include "methods/shared/baseline_config.hpp"

namespace surefoot {

namespace {

#define SLOT(member) \
  [](Config& c) { return field_slot(own_parameters<KissIcpParameters>(c).member); }

constexpr const char* kKiss = "KISS-ICP 1.2.3+10, KISSConfig";

const ConfigField kFields[] = {
    {"kiss_icp.max_range", SLOT(max_range), "100", "m", 1.0, 1000.0,
     "farther deskewed points are left out; also the map's radius", kKiss},
    {"kiss_icp.min_range", SLOT(min_range), "0", "m", 0.0, 100.0,
     "nearer deskewed points are left out", kKiss},
    {"kiss_icp.deskew", SLOT(deskew), "true", "", 0, 0,
     "points are brought to the scan's end by the last motion", kKiss},
    {"kiss_icp.voxel_size", SLOT(voxel_size), "1.0", "m", 0.05, 10.0,
     "cell of the map; half of it thins what enters the map, 1.5 of it what is registered", kKiss},
    {"kiss_icp.max_points_per_voxel", SLOT(max_points_per_voxel), "20", "", 1, 64,
     "a full cell takes no more points", kKiss},
    {"kiss_icp.initial_threshold", SLOT(initial_threshold), "2", "m", 1e-3, 100.0,
     "adaptive threshold before anything was learnt", kKiss},
    {"kiss_icp.min_motion_th", SLOT(min_motion_th), "0.1", "m", 0.0, 10.0,
     "smaller deviations from the prediction do not change the threshold", kKiss},
    {"kiss_icp.max_num_iterations", SLOT(max_num_iterations), "500", "", 1, 10000,
     "iterations at most", kKiss},
    {"kiss_icp.convergence_criterion", SLOT(convergence_criterion), "0.0001", "m, rad", 0.0, 1.0,
     "stop when an update's norm is below this", kKiss},
};

#undef SLOT

}  // namespace

const Method& kiss_icp_method() {
  static const Method method = {
      .name = "kiss-icp",
      .fields = kFields,
      .make_parameters = [] { return std::any(KissIcpParameters{}); },
      .presets =
          [] {
            return std::vector<Preset>{{"kiss-icp", baseline_config("kiss-icp")}};
          },
      .make_front_end = make_front_end<KissIcpFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
