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

/// Whether a registration is plausible at all: ok, too_few_matches (health.min_matches) or
/// diverged. Degeneracy is judged apart (information.hpp).
[[nodiscard]] Judgement judge_registration(const RegistrationEnd& end,
                                           const Config::Health& config);

/// Likewise, and whether the share of the points that have a match suffices
/// (health.min_match_ratio).
[[nodiscard]] Judgement judge_with_share(const RegistrationEnd& end, const Config::Health& config);

}  // namespace surefoot
