// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Trajectories to compare, as a person names them: a file of any format, a run's folder, a
// recording with its truth, a data set's reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/truth_files.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

/// How a trajectory is written; automatic: found out.
enum class TrajectoryFormat { automatic, tum, kitti };

struct ReferenceRequest {
  std::filesystem::path path;  ///< a file, a bag, a recording with a gt.tum, a run's folder
  std::string dataset;         ///< whose reference it is; empty: of none
  std::string topic;           ///< where it is a bag
  TrajectoryFormat format = TrajectoryFormat::automatic;
};

/// What estimates are compared with.
struct ReferenceTrajectory {
  std::filesystem::path file;  ///< that was read
  io::Truth truth;
  /// Of the estimates: TUM where there are stamps to pair by, else KITTI.
  TrajectoryFormat format = TrajectoryFormat::tum;
  bool is_format_given = false;  ///< what was asked for, and not found out
  bool is_foreign = false;       ///< neither TUM's nor KITTI's: `truth.what` says what it is
};

/// The trajectory in a run's folder, the truth in a recording's; any other path as it is.
[[nodiscard]] std::filesystem::path trajectory_file(const std::filesystem::path& path);

/// Throws io::ReadError.
[[nodiscard]] ReferenceTrajectory read_reference(const ReferenceRequest& request);

/// An estimate (a file, a bag's topic, or a run's folder) as the reference has it: its poses are
/// those of what the reference tells of. KITTI's poses have no stamps; they get their row's number,
/// which is never compared. Throws io::ReadError.
[[nodiscard]] Trajectory read_estimate(const std::filesystem::path& path,
                                       const ReferenceTrajectory& reference,
                                       const std::string& topic = {});

/// In how many segments, each in a frame of its own, a run left its trajectory (a file, or its
/// folder): 1 for any other.
[[nodiscard]] std::size_t segments_of(const std::filesystem::path& path);

/// The poses of such a trajectory, by their numbers, with which it goes on in another segment's
/// frame: none of any other.
[[nodiscard]] std::vector<std::size_t> segment_begins(const std::filesystem::path& path);

/// What estimates are called: the file without extension, or the run's folder; whole paths where
/// these are not unique.
[[nodiscard]] std::vector<std::string> estimate_names(
    const std::vector<std::filesystem::path>& paths);

}  // namespace surefoot::runs
