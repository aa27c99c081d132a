// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// The scan's points at its mid-scan instant, in the LiDAR frame of that instant [m]: the
/// paper's eqs. (10)-(12), Algorithm 1 line 7. Points without times stay where they are.
[[nodiscard]] std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan,
                                                  const ScanTrajectory& trajectory,
                                                  const Workers& workers);

}  // namespace surefoot
