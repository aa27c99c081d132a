// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Loops judged by where the robot really was.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mapping/walk_mapper.hpp"
#include "runs/map_outcome.hpp"
#include "runs/run_options.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

/// The truth that was given, or that beside the recording, by which loops are judged, as finely as
/// that needs; empty if there is none. A broken file is told to `say`, and no reason to have no
/// map.
[[nodiscard]] Trajectory truth_of_loops(const RunOptions& options,
                                        const std::function<void(const std::string& text)>& say);

/// How far a loop's motion is from the true one, in what it claims to hold.
struct LoopError {
  double metres = 0.0;
  double degrees = 0.0;
  /// Nothing that is called a loop may be farther off.
  [[nodiscard]] bool right() const { return metres < 0.2 && degrees < 2.0; }
};

struct LoopTruth {
  std::vector<LoopError> errors;  ///< one a loop
  std::vector<bool> revisits;     ///< of each piece: an earlier one lies within 3 m
  std::vector<bool> found;        ///< of each revisit: a loop was taken there, or one piece aside
  std::size_t taken = 0;
  std::size_t taken_false = 0;

  [[nodiscard]] LoopScore score() const;
};

/// `truth`: T_world_lidar. Throws std::runtime_error where it does not reach over the pieces.
[[nodiscard]] LoopTruth judge_loops(const mapping::WalkMapper& mapper, const Trajectory& truth,
                                    double way_between);

}  // namespace surefoot::runs
