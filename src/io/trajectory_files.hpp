// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Trajectories as the field keeps them. TUM: `t x y z qx qy qz qw`, t in seconds, `#` comments.
// KITTI: the 12 numbers of the upper 3x4 matrix, row by row, no stamps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "surefoot/trajectory.hpp"

namespace surefoot::io {

/// Stamps and translations with nine decimals, the stamps exactly; quaternions with twelve.
[[nodiscard]] std::string format_tum(const Trajectory& trajectory);
[[nodiscard]] std::string format_kitti_poses(const Trajectory& trajectory);
/// Write the file whole or not at all. Throw WriteError.
void write_tum(const std::filesystem::path& file, const Trajectory& trajectory);
void write_kitti_poses(const std::filesystem::path& file, const Trajectory& trajectory);

/// Words are separated by any white space; stamps are read to the nanosecond; quaternions are
/// normalised. Throws ReadError naming the line.
[[nodiscard]] Trajectory parse_tum(std::string_view text);
/// The 3x3 parts are made rotations again, as they are written with few digits. Throws ReadError
/// naming the line.
[[nodiscard]] std::vector<Pose> parse_kitti_poses(std::string_view text);
/// Of one such row: twelve words. Throws ReadError naming the line.
[[nodiscard]] Pose pose_of_kitti_row(std::span<const std::string_view> words, std::size_t line);
/// The same from files; the message of a ReadError names the file too.
[[nodiscard]] Trajectory read_tum(const std::filesystem::path& file);
[[nodiscard]] std::vector<Pose> read_kitti_poses(const std::filesystem::path& file);
/// Of poses that are written more finely, those so far apart at least, and the last one. Neither
/// the file nor the poses between are ever in memory all at once.
[[nodiscard]] Trajectory read_tum_thinned(const std::filesystem::path& file, std::int64_t step_ns);

}  // namespace surefoot::io
