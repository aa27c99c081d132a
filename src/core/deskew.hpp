// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/parallel.hpp"
#include "core/preprocess.hpp"
#include "core/segment_motion.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// Brings points to their scan's mid-scan instant, one by one; as deskew().
class Deskewing {
 public:
  explicit Deskewing(const ScanTrajectory& trajectory);

  /// A point [m, LiDAR frame at its instant] that was measured at the share tau of the scan.
  [[nodiscard]] Eigen::Vector3f operator()(const Eigen::Vector3f& point, float tau) const;

 private:
  std::vector<SegmentMotion> segments_;
};

/// The scan's points at its mid-scan instant, in the LiDAR frame of that instant [m]: the
/// paper's eqs. (10)-(12), Algorithm 1 line 7. Points without times stay where they are.
[[nodiscard]] std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan,
                                                  const ScanTrajectory& trajectory,
                                                  const Workers& workers);

}  // namespace surefoot
