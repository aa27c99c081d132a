// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The truth that lies beside a recording, where the run's path is to be seen with it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"
#include "report/run_picture.hpp"
#include "runs/run_options.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

/// A recording's truth, where it has one.
inline constexpr const char* kTruthFile = "gt.tum";

/// The gt.tum of the recording, poses of the LiDAR: in its folder, beside its file, or beside the
/// folder of a rosbag2; empty if there is none.
[[nodiscard]] std::filesystem::path truth_beside(const std::filesystem::path& input);

/// That of a run's options: the file that was given, else the recording's; empty if there is none,
/// or if the poses that are written are not those of the LiDAR.
[[nodiscard]] std::filesystem::path truth_file(const RunOptions& options);

/// The poses in whatever file eval takes as a reference. Throws io::ReadError, also where they have
/// no stamps or no rotations.
[[nodiscard]] Trajectory read_truth_poses(const std::filesystem::path& file);

/// How a run is compared with its truth: the truth interpolated at the run's stamps; where its
/// poses are too far apart for that, poses with the nearest stamps.
[[nodiscard]] evaluation::AssociationOptions pairing_with(const Trajectory& truth,
                                                          const Trajectory& measured);

/// That the truth tells of other times than those from `first_ns` to `last_ns`, with both; empty
/// where they have some in common.
[[nodiscard]] std::string other_times(const std::filesystem::path& file, const Trajectory& truth,
                                      std::int64_t first_ns, std::int64_t last_ns);

/// T_world_map by which a run is laid on its truth to be looked at: by orientations, too. On a
/// straight way positions leave the turn about it open, and the map would lie on its side. Throws
/// std::runtime_error where truth and run have no time in common.
[[nodiscard]] Pose laid_on_truth(const evaluation::AssociatedTrajectories& pairs);

/// The truth from the run's first to its last pose, thinned to a few thousand.
[[nodiscard]] Trajectory truth_between(const Trajectory& truth, std::int64_t first_ns,
                                       std::int64_t last_ns);

/// The same in the run's own map frame; empty where truth and run have no time in
/// common or the truth is none that can be compared with. Where loops were taken it is laid on the
/// way after them, so that what they mended is seen.
[[nodiscard]] Trajectory truth_in_map(const Trajectory& truth, const Trajectory& measured,
                                      const report::DrawnLoops& loops = {});

}  // namespace surefoot::runs
