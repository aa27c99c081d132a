// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The folder that a run leaves behind.
#pragma once

#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "mapping/map_builder.hpp"
#include "report/run_picture.hpp"
#include "runs/bounded_path.hpp"
#include "runs/deskew_samples.hpp"
#include "runs/output_folder.hpp"
#include "runs/run_options.hpp"
#include "runs/scans_csv.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

/// The measured poses of a segment, and from which stamp to which they are, in whatever order.
struct SegmentSpan {
  std::size_t poses = 0;
  std::int64_t first_ns = 0, last_ns = 0;
};

/// What segments there are, by their numbers, if several: a line each.
[[nodiscard]] std::vector<std::string> segment_lines(const std::map<int, SegmentSpan>& segments);

/// The trajectories and scans.csv grow line by line, so that whatever ends the run leaves whole
/// lines; the rest is written by finish(), run.yaml last: a run that has it came to its end.
class RunOutput {
 public:
  /// Makes the folder, in which all stays as it is. Throws std::runtime_error naming what cannot be
  /// written.
  explicit RunOutput(const RunOptions& options);
  /// An earlier run's files go; before add(). Throws likewise.
  void begin(const RunOptions& options);

  /// A line for a scan: in scans.csv and trajectory_kitti.txt always, in trajectory.tum only if its
  /// pose was measured. `T_lidar_written`: where the frame whose poses are written sits.
  void add(const std::string& name, const Estimate& estimate, const Pose& T_lidar_written,
           const StepTimes& times);
  /// Called after add(): the sweep may be one that shows what deskewing does.
  void add_sample(const Scan& scan, const Estimate& estimate);
  /// map.ply, deskewing.ply, the picture and run.yaml.
  void finish(const RunOptions& options, const RunDescription& description,
              const mapping::MapBuilder& map, report::DrawnLoops loops);

  [[nodiscard]] const OutputFolder& folder() const { return folder_; }
  /// All poses but those of rejected scans.
  [[nodiscard]] std::size_t poses() const { return path_.added(); }
  [[nodiscard]] double length() const { return length_; }  ///< of the way between them [m]
  /// Of each segment that has measured poses, by its number.
  [[nodiscard]] const std::map<int, SegmentSpan>& segments() const { return segments_; }

 private:
  std::ofstream open(const char* name);
  void add_dense(const Estimate& estimate, const Pose& T_lidar_written);
  void write_segments() const;
  [[nodiscard]] Trajectory measured() const;
  [[nodiscard]] Trajectory truth_of(const RunOptions& options,
                                    const report::DrawnLoops& loops) const;

  OutputFolder folder_;
  std::ofstream csv_, tum_, kitti_, dense_;
  std::int64_t pose_period_ns_ = 0;  // of dense_
  std::int64_t dense_until_ns_ = std::numeric_limits<std::int64_t>::min() / 2;
  std::int64_t dense_mid_ns_ = std::numeric_limits<std::int64_t>::min();  // of the last scan
  BoundedPath path_;  // what the picture shows; the files have all of it
  double length_ = 0.0;
  std::map<int, SegmentSpan> segments_;
  DeskewSamples samples_;
  std::size_t lines_ = 0;
};

/// map.ply in a run's folder. Throws io::WriteError.
void write_map(const std::filesystem::path& folder, const mapping::MapBuilder& map);

}  // namespace surefoot::runs
