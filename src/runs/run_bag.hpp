// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "io/bags/bag_writer.hpp"
#include "runs/bounded_path.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::runs {

/// A bag's numbers of the topics that a run writes.
struct RunTopics {
  std::size_t scan, map, odometry, path, transforms, diagnostics;
};
/// To listeners, before there is something to say: who is there hears the first scan's already.
RunTopics add_run_topics(io::BagWriter& bag);

/// A run as a bag to be played or looked at: deskewed scans, the local map about once a second, the
/// odometry with covariance and twist, the path so far, transforms, and a diagnosis of every scan.
/// Everything of a scan is stamped with the instant of its pose. Frames are "odom" and "lidar", or
/// "base_link" with the LiDAR on it. To listeners that get what came before they did, what does not
/// change is told once, on /tf_static, and that "odom" lies in "map" as if they were one. The path
/// has a bounded number of poses, and one message of it comes to so many scans that it does not
/// cost more, however long the run.
class RunBag {
 public:
  /// `T_lidar_base`: where the base sits, if its poses are to be written; else the LiDAR's.
  RunBag(std::shared_ptr<io::BagWriter> bag, const std::optional<Pose>& T_lidar_base);

  /// Where "odom" lies in "map", for listeners: told again whenever it moves, and not at all until
  /// it is known.
  void place(const std::optional<Pose>& T_map_world);
  /// A scan's answer; `odometry` has just given it. Throws io::WriteError.
  void add(const std::string& name, const Estimate& estimate, const Odometry& odometry);
  /// Ends the bag; `run_yaml` goes with it where the format has room. Throws io::WriteError.
  void finish(const std::string& run_yaml);

 private:
  void write_fixed_transforms(std::int64_t stamp_ns);
  void write_pose(const Estimate& estimate);
  void write_clouds(const Estimate& estimate, const Odometry& odometry);
  void write_path();
  void write_diagnosis(const std::string& name, const Estimate& estimate);

  std::shared_ptr<io::BagWriter> bag_;
  Pose T_lidar_written_;
  bool of_base_;
  bool fixed_written_ = false;
  bool is_placed_ = false;  ///< in a saved map
  std::optional<Pose> T_map_world_;
  std::string frame_;  ///< whose poses are written
  RunTopics topics_;
  BoundedPath path_;
  int segment_ = 0;                 ///< of the path's poses
  std::uint64_t path_written_ = 0;  ///< poses when it was written last
  std::uint64_t next_path_ = 1;     ///< and with which it is again
  std::int64_t next_map_ns_ = 0;
  bool any_map_ = false;
};

}  // namespace surefoot::runs
