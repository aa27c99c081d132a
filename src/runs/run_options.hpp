// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "io/recording.hpp"
#include "runs/run_yaml.hpp"
#include "surefoot/config.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::runs {

inline constexpr const char* kDefaultMethod = "surefoot";

/// What a run is asked for.
struct RunOptions {
  std::string version;          ///< of the program, for run.yaml; empty: the release
  std::string command = "run";  ///< that asks, for run.yaml
  std::filesystem::path input;
  io::OpenOptions reader;
  bool is_live = false;                    ///< the input is the name of what is running, no file
  std::filesystem::path like;              ///< a live run's log
  std::vector<std::int64_t> only_stamps;   ///< of the scans that it used; empty: all are used
  std::vector<std::int64_t> reset_before;  ///< of those with which it began anew

  std::string method;  ///< empty: the config file's, else kDefaultMethod
  std::filesystem::path config_file;
  std::vector<std::string> settings;
  std::vector<double> extrinsic;  ///< x y z [m] roll pitch yaw [deg]
  std::string level;
  int threads = 1;

  std::size_t start = 0;
  std::size_t count = std::numeric_limits<std::size_t>::max();
  std::size_t stride = 1;

  std::filesystem::path output;
  bool overwrite = false;         ///< also files that no run has left
  std::filesystem::path mcap;     ///< a file for the run as messages; empty: none
  std::filesystem::path rosbag2;  ///< a folder for the same
  std::string pose_of = "lidar";
  double map_voxel = 0.1;           ///< [m]
  double pose_rate = 0.0;           ///< [Hz] of trajectory_dense.tum; 0: not written
  bool reference = false;           ///< of all scans at once; the recording is read twice
  bool loop_closure = false;        ///< also find loops, and write what they correct
  bool no_loops = false;            ///< they are found, but move nothing
  std::size_t loop_candidates = 3;  ///< places that are compared with each piece of way
  bool save_map = false;            ///< also the map to come back to
  std::filesystem::path localize;   ///< a saved map (file or folder) to say poses in; empty: none
  std::filesystem::path continued;  ///< a saved map (file or folder) to go on with; empty: none
  std::filesystem::path truth;      ///< to draw and compare with; empty: the recording's gt.tum
  bool no_map = false;
  bool no_picture = false;
  bool no_report = false;
  bool quiet = false;

  OptionTexts given;  ///< those of the above, but the input's and the parameters', that were given
};

/// options.method, else the method that the config file names, else the default. Throws
/// ConfigError, also where the two contradict each other.
[[nodiscard]] std::string method_of(const RunOptions& options);
/// Method, then the file, then the flags; the later wins. Throws ConfigError.
[[nodiscard]] Config config_of(const RunOptions& options);

/// T_lidar_x: from the frame whose poses are written (LiDAR or base) to the LiDAR.
[[nodiscard]] Pose written_frame(const RunOptions& options, const Config& config);

}  // namespace surefoot::runs
