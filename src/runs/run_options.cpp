// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_options.hpp"

#include <fmt/format.h>

#include "io/datasets.hpp"
#include "io/robots.hpp"
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

/// What the robot says of its own LiDAR, which may hang upside down; where the base's poses are
/// asked for, what the data set says.
std::optional<Pose> known_mount(const RunOptions& options) {
  const io::Robot* const robot = io::robot_of_scans(options.reader);
  if (robot != nullptr && options.level.empty()) return robot->T_base_lidar;
  const std::string& set = options.reader.dataset;
  if (options.pose_of != "base" || set.empty()) return std::nullopt;
  return io::dataset_named(set).T_base_lidar;
}

/// Two answers to how the LiDAR stands, of which one would be passed over.
void refuse_other_level(const RunOptions& options) {
  const char* const flag = !options.extrinsic.empty() ? "--extrinsic" : "--level";
  if (options.extrinsic.empty() && options.level.empty()) return;
  for (const std::string& setting : options.settings) {
    if (!setting.starts_with("level.mode=")) continue;
    throw ConfigError(
        fmt::format("--set {}: beside {}, which says it already; leave out one", setting, flag));
  }
}

std::vector<double> extrinsic_of(const Pose& mount) {
  const Eigen::Vector3d angles = roll_pitch_yaw(mount.rotation) * (180.0 / EIGEN_PI);
  const Eigen::Vector3d& at = mount.translation;
  return {at.x(), at.y(), at.z(), angles.x(), angles.y(), angles.z()};
}

}  // namespace

std::string method_of(const RunOptions& options) {
  const std::string named = options.config_file.empty() ? "" : method_of_file(options.config_file);
  if (options.method.empty()) return named.empty() ? kDefaultMethod : named;
  if (!named.empty() && named != options.method) {
    throw ConfigError(fmt::format(
        "{}: its parameters are of method {}, and --method says {}; leave --method out, or the "
        "line 'method: {}'",
        options.config_file.string(), named, options.method, named));
  }
  return options.method;
}

Config config_of(const RunOptions& options) {
  Config config = method_config(method_of(options));
  // What is known gives way to what is asked for, also by a run.yaml.
  if (const std::optional<Pose> known = known_mount(options)) {
    set_mount(extrinsic_of(*known), config);
  }
  if (!options.config_file.empty()) load_config_file(options.config_file, config);
  if (!options.extrinsic.empty()) set_mount(options.extrinsic, config);
  if (!options.level.empty()) set_parameter(config, "level.mode", options.level);
  refuse_other_level(options);
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
