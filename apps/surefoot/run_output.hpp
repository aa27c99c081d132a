// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The folder that a run leaves behind.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "map_builder.hpp"
#include "run_options.hpp"
#include "step_times.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::app {

/// What run.yaml tells about a run besides its parameters.
struct RunSummary {
  std::string input_description;
  std::vector<std::string> notes;
  std::string level;
  std::size_t scans = 0;
  std::size_t untrusted = 0;
  bool interrupted = false;
};

/// trajectory.tum, trajectory_kitti.txt and scans.csv grow line by line, so that whatever ends the
/// run leaves whole lines; the rest is written by finish().
class RunOutput {
 public:
  /// Makes the folder. Throws std::runtime_error naming what cannot be written.
  explicit RunOutput(const RunOptions& options);

  /// A line for a scan: in scans.csv and trajectory_kitti.txt always, in trajectory.tum only if its
  /// pose was measured. `T_lidar_written`: where the frame whose poses are written sits.
  void add(const std::string& name, const Estimate& estimate, const Pose& T_lidar_written,
           const StepTimes& times);
  /// run.yaml, map.ply and the picture.
  void finish(const RunOptions& options, const Config& config, const RunSummary& summary,
              const MapBuilder& map);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }

 private:
  std::ofstream open(const char* name);
  void add_dense(const Estimate& estimate, const Pose& T_lidar_written);

  std::filesystem::path folder_;
  std::ofstream tum_, kitti_, csv_, dense_;
  std::int64_t pose_period_ns_ = 0;  // of dense_
  std::int64_t dense_until_ns_ = std::numeric_limits<std::int64_t>::min() / 2;
  Trajectory trajectory_;
  std::vector<bool> untrusted_;
  std::size_t lines_ = 0;
};

/// The folder that was asked for, or a new one under results/ with results/latest pointing to it.
[[nodiscard]] std::filesystem::path make_output_folder(const std::filesystem::path& asked,
                                                       const std::filesystem::path& input);

}  // namespace surefoot::app
