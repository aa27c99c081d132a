// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One picture that tells how a run went: the map, the path from above, its height along
// the way, and height, roll and pitch over time.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "surefoot/trajectory.hpp"

namespace surefoot::report {

inline constexpr int kPictureWidth = 2000;   // [px]
inline constexpr int kPictureHeight = 1500;  // [px]

/// Places that were compared with where the robot had been before [m, map frame], and the way after
/// all loops.
struct DrawnLoops {
  using Places = std::pair<Eigen::Vector3d, Eigen::Vector3d>;
  std::vector<Places> taken;
  std::vector<Places> refused;
  Trajectory corrected;
};

/// What is drawn. Poses and points that are not finite, or farther than 1e9 m, are left out.
struct PictureInput {
  std::string title = {};                            ///< UTF-8, one line
  Trajectory trajectory = {};                        ///< T_world_lidar, z up
  std::span<const Eigen::Vector3f> map_points = {};  ///< [m], map frame
  Trajectory reference = {};         ///< truth in the map frame, same clock; may be empty
  std::vector<bool> untrusted = {};  ///< one flag a pose of `trajectory`, or empty
  std::vector<int> segments = {};    ///< likewise; no line joins poses of different ones
  DrawnLoops loops = {};             ///< drawn from above, and by height
};

/// Writes the picture as PNG or SVG, by the extension of `path`. The same input gives the same
/// PNG, byte for byte, on one machine (text needs the machine's fonts).
/// Throws std::invalid_argument if flags or segments have another length than `trajectory`, and
/// std::runtime_error naming the path if the extension is another one or the file cannot be
/// written.
void draw_run_picture(const PictureInput& input, const std::filesystem::path& path);

}  // namespace surefoot::report
