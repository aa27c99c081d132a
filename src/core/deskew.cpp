// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/deskew.hpp"

#include <algorithm>

#include "core/segment_motion.hpp"

namespace surefoot {

std::vector<Eigen::Vector3f> deskew(const PreparedScan& scan, const ScanTrajectory& trajectory,
                                    const Workers& workers) {
  if (scan.taus.empty()) return scan.points;

  const Pose T_lidar_map = trajectory.at(0.5).inverse();
  std::vector<SegmentMotion> segments;
  for (std::size_t k = 0; k < trajectory.segments(); ++k) {
    segments.emplace_back(T_lidar_map * trajectory.boundary(k), trajectory.segment_twist(k));
  }
  const auto K = static_cast<double>(segments.size());
  std::vector<Eigen::Vector3f> deskewed(scan.points.size());
  workers.for_chunks(scan.points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double scaled = static_cast<double>(scan.taus[i]) * K;
      const std::size_t k = std::min(static_cast<std::size_t>(scaled), segments.size() - 1);
      const double u = scaled - static_cast<double>(k);  // [Eq 10]
      // [Eq 11] and [Eq 12]: p* = T_mid^-1 T(tau) p, with T(tau) = T_k exp(u xi_k).
      deskewed[i] = segments[k](u, scan.points[i].cast<double>()).cast<float>();
    }
  });
  return deskewed;
}

}  // namespace surefoot
