// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "dataset/recording.hpp"
#include "surefoot/config.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::app {

inline constexpr const char* kDefaultMethod = "surefoot";

/// What `surefoot run` was asked for.
struct RunOptions {
  std::filesystem::path input;
  dataset::OpenOptions reader;

  std::string method;  // empty: the config file's, else kDefaultMethod
  std::filesystem::path config_file;
  std::vector<std::string> settings;
  std::vector<double> extrinsic;  // x y z [m] roll pitch yaw [deg]
  std::string level;
  int threads = 1;

  std::size_t start = 0;
  std::size_t count = std::numeric_limits<std::size_t>::max();
  std::size_t stride = 1;

  std::filesystem::path output;
  std::string pose_of = "lidar";
  double map_voxel = 0.1;  // [m]
  double pose_rate = 0.0;  // [Hz] of trajectory_dense.tum; 0: not written
  bool no_map = false;
  bool no_picture = false;
  bool no_report = false;
  bool quiet = false;
};

void add_run_options(CLI::App& command, RunOptions& options);

/// Method, then the file, then the flags; the later wins. Throws ConfigError.
/// --method, else the method that the config file names, else the default. Throws ConfigError.
[[nodiscard]] std::string method_of(const RunOptions& options);
[[nodiscard]] Config make_config(const RunOptions& options);

/// T_lidar_x: from the frame whose poses are written (LiDAR or base) to the LiDAR.
[[nodiscard]] Pose written_frame(const RunOptions& options, const Config& config);

}  // namespace surefoot::app
