// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "run_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "command_line/option_checks.hpp"
#include "process/build_version.hpp"
#include "reader_options.hpp"

namespace surefoot::app {

namespace {

void add_method_options(CLI::App& command, runs::RunOptions& options) {
  command
      .add_option("--method", options.method, fmt::format("one of: {}", fmt::join(methods(), ", ")))
      ->default_str(fmt::format("that of --config, else {}", runs::kDefaultMethod));
  command.add_option("--config", options.config_file,
                     "YAML file of parameters, or a run.yaml: repeats its run");
  command.add_option("--set", options.settings, "a parameter: key=value; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--extrinsic", options.extrinsic,
                  "T_base_lidar: x y z [m] roll pitch yaw [deg]; the base is level at the start")
      ->expected(6)
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--level", options.level,
                  "ground: from the first scan; none: the LiDAR's own z axis")
      ->check(CLI::IsMember({"ground", "none"}))
      ->excludes("--extrinsic");
  command.add_option("--threads", options.threads, "threads at most; the result is the same")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--start", options.start, "scans to pass over at first")
      ->check(command_line::whole_number(0));
  command.add_option("--count", options.count, "scans to use at most")
      ->check(command_line::whole_number(1));
  command.add_option("--stride", options.stride, "use every n-th scan")
      ->check(command_line::whole_number(1));
}

void add_map_options(CLI::App& command, runs::RunOptions& options) {
  command.add_option("--map-voxel", options.map_voxel, "one point per cube in map.ply [m]")
      ->check(command_line::number_within(0.01, 10.0))
      ->capture_default_str();
  command.add_flag("--loop-closure", options.loop_closure,
                   "also find places that were visited before, and write trajectory_optimized.tum, "
                   "map_optimized.ply and loops.csv");
  command
      .add_option("--localize", options.localize,
                  "a map that surefoot map has written, or its folder: also write where in it the "
                  "robot is (trajectory_map.tum, localization.csv)")
      ->type_name(command_line::kFileType);
  command
      .add_option("--map", options.continued,
                  "a map that surefoot map has written, or its folder: continue it; this run's map "
                  "is joined to it, and map.surefoot and trajectory_optimized.tum are in its frame")
      ->type_name(command_line::kFileType);
  command.add_flag("--no-map", options.no_map, "do not write map.ply")->excludes("--map-voxel");
}

void add_result_options(CLI::App& command, runs::RunOptions& options) {
  command.add_option(
      "-o,--output", options.output,
      "folder for the results (default: results/<input>-<time>, linked as results/latest)");
  command.add_flag("--overwrite", options.overwrite,
                   "write also where files lie that no run has left, or a map.surefoot");
  command.add_option("--mcap", options.mcap,
                     "also write scans, local map, odometry, path, transforms and diagnostics as "
                     "ROS 2 messages to this MCAP file");
  command.add_option("--rosbag2", options.rosbag2, "the same to this folder, as a sqlite3 bag");
  command
      .add_option("--truth", options.truth,
                  "a trajectory with stamps and rotations, of the poses that are written: the "
                  "picture and the report compare with it (default: the recording's gt.tum)")
      ->type_name(command_line::kFileType);
  command
      .add_option("--pose-of", options.pose_of,
                  "frame whose poses are written (base needs --extrinsic)")
      ->check(CLI::IsMember({"lidar", "base"}))
      ->capture_default_str();
  command
      .add_option("--pose-rate", options.pose_rate,
                  "also write trajectory_dense.tum with so many poses a second, within scans [Hz]")
      ->check(command_line::number_within(0.1, 100000.0));
  command.add_flag("--no-picture", options.no_picture, "do not draw the picture");
  command.add_flag("--no-report", options.no_report, "do not write report.html");
  command.add_flag("-q,--quiet", options.quiet, "print errors only");
}

}  // namespace

void add_run_options(CLI::App& command, runs::RunOptions& options) {
  options.version = process::build_version();
  options.command = command.get_name();
  add_method_options(command, options);
  add_map_options(command, options);
  add_result_options(command, options);
  add_reader_options(command, options.reader);
}

}  // namespace surefoot::app
