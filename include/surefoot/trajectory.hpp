// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// Where a frame was at one stated instant.
struct StampedPose {
  std::int64_t stamp_ns = 0;
  Pose pose;
};

/// Poses in the order of their stamps.
using Trajectory = std::vector<StampedPose>;

}  // namespace surefoot
