// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/floam/floam_front_end.hpp"
#include "methods/floam/floam_parameters.hpp"
#include "methods/registry.hpp"
#include "methods/shared/baseline_config.hpp"

namespace surefoot {

namespace {

#define SLOT(member) [](Config& c) { return field_slot(own_parameters<FloamParameters>(c).member); }

constexpr const char* kFloam = "F-LOAM 76e9b02, floam_velodyne.launch";

const ConfigField kFields[] = {
    {"floam.scan_line", SLOT(scan_line), "16", "", 16, 64, "lasers: 16, 32 or 64", kFloam},
    {"floam.max_dis", SLOT(max_dis), "90", "m", 1.0, 1000.0,
     "points that are farther horizontally are left out", kFloam},
    {"floam.min_dis", SLOT(min_dis), "0.5", "m", 0.0, 100.0,
     "points that are nearer horizontally are left out", kFloam},
    {"floam.map_resolution", SLOT(map_resolution), "0.2", "m", 0.05, 10.0,
     "thinning of edge points; of surface points twice that", kFloam},
    {"floam.use_rings", SLOT(use_rings), "false", "", 0, 0,
     "lines from the scan's ring numbers; the original counts them by elevation", kFloam},
    {"floam.whole_sectors", SLOT(whole_sectors), "false", "", 0, 0,
     "use every point of a sector; the original loses the last", kFloam},
    {"floam.centred_planes", SLOT(centred_planes), "false", "", 0, 0,
     "fit planes about their centre; the original cannot represent planes through the map's origin",
     kFloam},
    {"floam.distortion_compensation", SLOT(distortion_compensation), "false", "", 0, 0,
     "the paper's two steps: deskew by the last motion, and for the map by the one found", kFloam},
};

#undef SLOT

void check(const Config& config) {
  const int lines = own_parameters<FloamParameters>(config).scan_line;
  if (lines != 16 && lines != 32 && lines != 64) {
    throw ConfigError("floam.scan_line: got " + number_text(lines) + ", expected 16, 32 or 64");
  }
}

}  // namespace

const Method& floam_method() {
  static const Method method = {
      .name = "floam",
      .fields = kFields,
      .make_parameters = [] { return std::any(FloamParameters{}); },
      .check = check,
      .presets =
          [] {
            return std::vector<Preset>{{"floam", baseline_config("floam")}};
          },
      .make_front_end = make_front_end<FloamFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
