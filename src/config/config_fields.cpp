// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/config_fields.hpp"

#include "config/method.hpp"

namespace surefoot {

namespace {

constexpr const char* kLevelModes[] = {"ground", "mount", "none"};

#define SLOT(member) [](Config& c) { return field_slot(c.member); }
#define WORDS(member, words) [](Config& c) { return field_slot(c.member, words); }

const ConfigField kInput[] = {
    {"preprocess.min_range", SLOT(preprocess.min_range), "0.5", "m", 0.0, 100.0,
     "nearer points are the robot's own body", kChosen},
    {"preprocess.max_range", SLOT(preprocess.max_range), "100", "m", 1.0, 1000.0,
     "farther points are left out", "VLP-16 manual: range 100 m"},
    {"preprocess.min_points", SLOT(preprocess.min_points), "100", "", 1, 1e6,
     "a scan with fewer valid points is rejected", kChosen},
    {"preprocess.min_extent", SLOT(preprocess.min_extent), "0.5", "m", 0.0, 100.0,
     "a cloud with a smaller diagonal is rejected", kChosen},

    {"level.mode", WORDS(level.mode, kLevelModes), "ground", "", 0, 0,
     "where the level frame comes from: the ground in the first scan, the mount, or the LiDAR's z",
     kChosen},
    {"level.max_tilt_deg", SLOT(level.max_tilt_deg), "45", "deg", 0.0, 80.0,
     "a plane steeper than this in the LiDAR's frame is not taken for the ground", kChosen},
    {"level.mount_x", SLOT(level.mount_x), "0", "m", -100, 100, "T_base_lidar, for mode mount",
     "user"},
    {"level.mount_y", SLOT(level.mount_y), "0", "m", -100, 100, "T_base_lidar", "user"},
    {"level.mount_z", SLOT(level.mount_z), "0", "m", -100, 100, "T_base_lidar", "user"},
    {"level.mount_roll_deg", SLOT(level.mount_roll_deg), "0", "deg", -360, 360,
     "T_base_lidar = Rz(yaw) Ry(pitch) Rx(roll)", "user"},
    {"level.mount_pitch_deg", SLOT(level.mount_pitch_deg), "0", "deg", -360, 360, "T_base_lidar",
     "user"},
    {"level.mount_yaw_deg", SLOT(level.mount_yaw_deg), "0", "deg", -360, 360, "T_base_lidar",
     "user"},

    {"motion_prior.max_extrapolation", SLOT(motion_prior.max_extrapolation), "0.5", "s", 0.0, 10.0,
     "after a longer gap the last velocity is carried on for this long only", kChosen},
};

const ConfigField kHealth[] = {
    {"health.min_matches", SLOT(health.min_matches), "30", "", 6, 1e6,
     "fewer correspondences: the scan is not registered", kChosen},
    {"health.min_match_ratio", SLOT(health.min_match_ratio), "0.3", "", 0.0, 1.0,
     "share of the registered points that must have a correspondence at the end (method surefoot: "
     "none, the share is evidence among other)",
     kChosen},
    {"health.max_correction", SLOT(health.max_correction), "3", "m", 0.001, 100.0,
     "a registration farther from the prediction has diverged", kChosen},
    {"health.max_correction_deg", SLOT(health.max_correction_deg), "45", "deg", 0.001, 180.0,
     "a registration turned farther from the prediction has diverged", kChosen},
    {"health.min_information", SLOT(health.min_information), "0.01", "", 0.0, 1.0,
     "a direction with a smaller share of an even scene's information is degenerate", kChosen},
    {"health.restart_after", SLOT(health.restart_after), "10", "", 1, 1e6,
     "more scans in a row that were not registered: method surefoot looks for its place, paper "
     "begins its map anew",
     kChosen},
};

#undef WORDS
#undef SLOT

}  // namespace

FieldSlot field_slot(bool& value) {
  static constexpr const char* words[] = {"true", "false"};
  return WordSlot{
      words, &value,
      [](const void* at) -> std::size_t { return *static_cast<const bool*>(at) ? 0 : 1; },
      [](void* at, std::size_t word) { *static_cast<bool*>(at) = word == 0; }};
}

std::span<const ConfigField> input_fields() { return kInput; }
std::span<const ConfigField> health_fields() { return kHealth; }

const std::vector<ConfigField>& config_fields() {
  static const std::vector<ConfigField> fields = [] {
    std::vector<ConfigField> all;
    for (const auto& table : field_tables()) all.insert(all.end(), table.begin(), table.end());
    return all;
  }();
  return fields;
}

}  // namespace surefoot
