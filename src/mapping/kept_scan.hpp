// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace surefoot::mapping {

/// A scan as it is kept until its piece of way is over.
struct KeptScan {
  std::int64_t stamp_ns = 0;
  Eigen::Vector3f eye = Eigen::Vector3f::Zero();  ///< where the LiDAR was [m]
  std::vector<Eigen::Vector3f> points;            ///< [m]
};

}  // namespace surefoot::mapping
