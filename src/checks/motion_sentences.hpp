// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the motion said, in words, and what follows from it.
#pragma once

#include <string>
#include <vector>

#include "checks/recording_check.hpp"

namespace surefoot::checks {

/// What the sweeps' times look like: before or after the stamp, which way round.
[[nodiscard]] std::vector<std::string> time_sentences(const Figures& figures);

/// Adds what the trials and the stamps' comparison say, and what a run would suffer of. `reader`:
/// how the recording was read.
void conclude(const MotionCheck& motion, const io::OpenOptions& reader, const Figures& figures,
              std::vector<Finding>& findings, std::vector<std::string>& sentences);

}  // namespace surefoot::checks
