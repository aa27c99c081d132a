// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "run_options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <numbers>

#include "config_file.hpp"
#include "option_checks.hpp"
#include "reader_options.hpp"

namespace surefoot::app {

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

void add_run_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("input", options.input,
                  "folder of scans (PCD, PLY, KITTI .bin) or a VLP-16 capture (.pcap, .pcapng)")
      ->required();
  command.add_option(
      "-o,--output", options.output,
      "folder for the results (default: results/<input>-<time>, linked as results/latest)");
  command
      .add_option("--method", options.method, fmt::format("one of: {}", fmt::join(methods(), ", ")))
      ->default_str(fmt::format("that of --config, else {}", kDefaultMethod));
  command.add_option("--config", options.config_file, "YAML file of parameters, or a run.yaml");
  command.add_option("--set", options.settings, "a parameter: key=value; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--extrinsic", options.extrinsic,
                  "T_base_lidar: x y z [m] roll pitch yaw [deg]; the base is level at the start")
      ->expected(6)
      ->delimiter(',');
  command
      .add_option("--level", options.level,
                  "ground: from the first scan; none: the LiDAR's own z axis")
      ->check(CLI::IsMember({"ground", "none"}))
      ->excludes("--extrinsic");
  command.add_option("--threads", options.threads, "threads at most; the result is the same")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--start", options.start, "scans to pass over at first")
      ->check(whole_number(0));
  command.add_option("--count", options.count, "scans to use at most")->check(whole_number(1));
  command.add_option("--stride", options.stride, "use every n-th scan")->check(whole_number(1));
  command
      .add_option("--pose-of", options.pose_of,
                  "frame whose poses are written (base needs --extrinsic)")
      ->check(CLI::IsMember({"lidar", "base"}))
      ->capture_default_str();
  command.add_option("--map-voxel", options.map_voxel, "one point per cube in map.ply [m]")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  command
      .add_option("--pose-rate", options.pose_rate,
                  "also write trajectory_dense.tum with so many poses a second, within scans [Hz]")
      ->check(CLI::Range(0.1, 100000.0));
  command.add_flag("--no-map", options.no_map, "do not write map.ply");
  command.add_flag("--no-picture", options.no_picture, "do not draw the picture");
  command.add_flag("--no-report", options.no_report, "do not write report.html");
  command.add_flag("-q,--quiet", options.quiet, "print errors only");
  add_reader_options(command, options.reader);
}

std::string method_of(const RunOptions& options) {
  if (!options.method.empty()) return options.method;
  const std::string named = options.config_file.empty() ? "" : method_of_file(options.config_file);
  return named.empty() ? kDefaultMethod : named;
}

Config make_config(const RunOptions& options) {
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

}  // namespace surefoot::app
