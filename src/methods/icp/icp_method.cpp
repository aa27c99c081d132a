// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/icp/icp_front_end.hpp"
#include "methods/icp/icp_parameters.hpp"
#include "methods/registry.hpp"
#include "methods/shared/baseline_config.hpp"

namespace surefoot {

namespace {

constexpr const char* kTargets[] = {"scan", "map"};

#define SLOT(member) [](Config& c) { return field_slot(own_parameters<IcpParameters>(c).member); }
#define WORDS(member, words) \
  [](Config& c) { return field_slot(own_parameters<IcpParameters>(c).member, words); }

constexpr const char* kOpen3d = "Open3D 0.18, ICPConvergenceCriteria";

const ConfigField kFields[] = {
    {"icp.target", WORDS(target, kTargets), "scan", "", 0, 0,
     "align with the scan before, or with a map of all before", "Besl and McKay 1992"},
    {"icp.constant_velocity", SLOT(constant_velocity), "true", "", 0, 0,
     "begin where the last motion leads; false: at the last pose", kChosen},
    {"icp.max_correspondence_distance", SLOT(max_correspondence_distance), "1.0", "m", 0.01, 20.0,
     "farther nearest neighbours are no match; Open3D has no default", kChosen},
    {"icp.max_iteration", SLOT(max_iteration), "30", "", 1, 10000, "iterations at most", kOpen3d},
    {"icp.relative_fitness", SLOT(relative_fitness), "1e-06", "", 0.0, 1.0,
     "stop when the share of matched points changes by less, and", kOpen3d},
    {"icp.relative_rmse", SLOT(relative_rmse), "1e-06", "m", 0.0, 1.0,
     "the matches' RMS distance changes by less", kOpen3d},
    {"icp.voxel_size", SLOT(voxel_size), "1.0", "m", 0.05, 20.0,
     "cell of the map for target map; at least max_correspondence_distance", "kiss_icp.voxel_size"},
    {"icp.max_points_per_voxel", SLOT(max_points_per_voxel), "20", "", 1, 64,
     "for target map: a full cell takes no more points", "kiss_icp.max_points_per_voxel"},
};

#undef WORDS
#undef SLOT

void check(const Config& config) {
  const IcpParameters& icp = own_parameters<IcpParameters>(config);
  if (icp.max_correspondence_distance > icp.voxel_size) {
    throw ConfigError("icp.voxel_size (" + number_text(icp.voxel_size) +
                      " m) must not be less than icp.max_correspondence_distance (" +
                      number_text(icp.max_correspondence_distance) + " m)");
  }
}

/// ICP has no range limits of its own; near points are the robot's body for it too.
std::vector<Preset> presets() {
  Config config = baseline_config("icp");
  config.preprocess = Config().preprocess;
  return {{"icp", config}};
}

}  // namespace

const Method& icp_method() {
  static const Method method = {
      .name = "icp",
      .fields = kFields,
      .make_parameters = [] { return std::any(IcpParameters{}); },
      .check = check,
      .presets = presets,
      .make_front_end = make_front_end<IcpFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
