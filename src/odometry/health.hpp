// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "odometry/registration.hpp"
#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot {

/// A status and the sentence that explains it.
struct Verdict {
  Status status = Status::ok;
  std::string message;
};

/// Whether a registration that started at `T_0` with `points` source points can be trusted: ok,
/// too_few_matches or diverged. Degeneracy is judged apart (information.hpp).
[[nodiscard]] Verdict judge_registration(const Registration& registration, const Pose& T_0,
                                         std::size_t points, const Config::Health& config);

}  // namespace surefoot
