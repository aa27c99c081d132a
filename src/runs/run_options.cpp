// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_options.hpp"

#include <fmt/format.h>

#include "runs/config_file.hpp"

namespace surefoot::runs {

namespace {

void set_mount(const std::vector<double>& extrinsic, Config& config) {
  static constexpr const char* names[] = {"level.mount_x",         "level.mount_y",
                                          "level.mount_z",         "level.mount_roll_deg",
                                          "level.mount_pitch_deg", "level.mount_yaw_deg"};
  set_parameter(config, "level.mode", "mount");
  for (std::size_t i = 0; i < extrinsic.size(); ++i) {
    set_parameter(config, names[i], fmt::format("{}", extrinsic[i]));
  }
}

}  // namespace

std::string method_of(const RunOptions& options) {
  if (!options.method.empty()) return options.method;
  const std::string named = options.config_file.empty() ? "" : method_of_file(options.config_file);
  return named.empty() ? kDefaultMethod : named;
}

Config config_of(const RunOptions& options) {
  Config config = method_config(method_of(options));
  if (!options.config_file.empty()) load_config_file(options.config_file, config);
  if (!options.extrinsic.empty()) set_mount(options.extrinsic, config);
  if (!options.level.empty()) set_parameter(config, "level.mode", options.level);
  apply_settings(options.settings, config);
  validate(config);
  if (options.pose_of == "base" && config.level.mode != LevelMode::mount) {
    throw ConfigError("--pose-of base: the base is known by --extrinsic (level.mode mount) only");
  }
  return config;
}

Pose written_frame(const RunOptions& options, const Config& config) {
  if (options.pose_of == "lidar") return {};
  return mount_pose(config.level).inverse();
}

}  // namespace surefoot::runs
