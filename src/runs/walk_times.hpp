// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// When each scan of a run was, told by a clock that goes on.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot::runs {

/// [ns] ascending: the stamps, but where the sensor's clock was set back the time along the walk
/// that the run's map has, too. A scan without a pose is as far from the next one with a pose as
/// its stamp says, and after the scans before it. Of as many scans as there are poses.
[[nodiscard]] std::vector<std::int64_t> walk_times(const std::vector<std::int64_t>& stamps_ns,
                                                   const std::vector<std::optional<Pose>>& poses);

}  // namespace surefoot::runs
