// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// True trajectories as data sets give them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/datasets.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::io {

struct Truth {
  Trajectory poses;
  bool has_stamps = true;     ///< else they are numbered
  bool has_rotations = true;  ///< else the rotations are the identity and mean nothing
  /// Frame or point that it tells, in the LiDAR's frame.
  Pose T_lidar_truth;
  std::string what;  ///< "poses, 8 columns", for a note
};

/// A table by the number of its columns, which spaces or commas separate: 8 (t, position,
/// quaternion x y z w), 9 (seconds, nanoseconds, the same), 4 (t and position), 13 (t and a 3x4
/// matrix) or 12 (the matrix alone). Whole times are in nanoseconds, microseconds or milliseconds
/// as WholeTimes tells (stamps.hpp); one of 16 digits or more always. Quaternions 0 0 0 0 say that
/// only positions are known. Lines of '#', and one of names at the top, are passed over, but for
/// the order of the quaternion that they tell. Throws ReadError naming the line.
[[nodiscard]] Truth parse_truth_table(std::string_view text);

/// KITTI's OXTS records, one text each, in the devkit's local frame (Mercator about the first):
/// poses of the inertial unit.
[[nodiscard]] Pose pose_of_oxts(std::string_view text, double scale);
[[nodiscard]] double mercator_scale(std::string_view text);

/// The truth of a data set (nullptr: of none) in a file, a folder or a bag's topic. Throws
/// ReadError.
[[nodiscard]] Truth read_truth(const std::filesystem::path& path, const Dataset* set,
                               const std::string& topic = {});

}  // namespace surefoot::io
