// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What came of a run's loops, and of its place in a saved map.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "surefoot/pose.hpp"

namespace surefoot::runs {

/// Loops against the truth.
struct LoopScore {
  std::size_t revisits = 0;  ///< pieces of way within 3 m of an earlier one
  std::size_t found = 0;     ///< of these, with a loop there, or one piece aside
  std::size_t taken_false = 0;
};

/// What came of the map that was to be continued.
struct JoinOutcome {
  bool joined = false;
  std::size_t compared = 0;        ///< places
  std::size_t taken = 0;           ///< loops
  std::size_t near = 0;            ///< places that both have seen
  std::size_t pieces = 0;          ///< of the joint map
  std::string message;             ///< why not
  std::optional<Pose> begin = {};  ///< where the run begins in the map
};

struct MapOutcome {
  std::size_t pieces = 0;
  std::size_t candidates = 0;
  std::size_t taken = 0;
  double moved = 0.0;  ///< [m] the largest correction of a pose
  std::optional<LoopScore> score;
  std::string unjudged = {};  ///< why they are not held against the truth that there is
  std::optional<JoinOutcome> join;
};

struct LocalizationOutcome {
  std::size_t scans = 0;
  std::size_t found = 0;              ///< scans whose place in the map is known
  std::optional<double> first_found;  ///< [s] after the first scan
  std::string message;                ///< about the last scan
};

}  // namespace surefoot::runs
