// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// Where a registration began and ended.
struct RegistrationEnd {
  Pose T_0;                ///< T_map_lidar as predicted
  Pose T_map_lidar;        ///< as found
  int matches = 0;         ///< of the points, with a partner in the map
  std::size_t points = 0;  ///< that were registered
};

/// A status and the sentence that explains it.
struct Judgement {
  Status status = Status::ok;
  std::string message;
};

/// Whether a registration can be trusted: ok, too_few_matches or diverged. Degeneracy is judged
/// apart (information.hpp). `min_match_ratio`: share of the points that must have a match, 0: none.
[[nodiscard]] Judgement judge_registration(const RegistrationEnd& end, double min_match_ratio,
                                           const Config::Health& config);

}  // namespace surefoot
